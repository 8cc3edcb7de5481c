// SPDX-License-Identifier: Apache-2.0
/// Files: meshes as OFF, OBJ and STL.
///
///     mesh_file       read_mesh and write_mesh, the format by the extension
///     off, obj, stl   the formats, from and to text in memory
///     text_reader     lines and words with messages that say where; coordinate: numbers among them
///     text_writer     numbers that read back as the same value
///     output_file     a file that appears complete or not at all
#ifndef CLEAVE_IO_HPP
#define CLEAVE_IO_HPP

#include <cleave/io/coordinate.hpp>
#include <cleave/io/mesh_file.hpp>
#include <cleave/io/obj.hpp>
#include <cleave/io/off.hpp>
#include <cleave/io/output_file.hpp>
#include <cleave/io/stl.hpp>
#include <cleave/io/text_reader.hpp>
#include <cleave/io/text_writer.hpp>

#endif
