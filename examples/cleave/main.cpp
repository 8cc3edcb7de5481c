// SPDX-License-Identifier: Apache-2.0
// `cleave`: exact Boolean operations on solids, from the command line.
#include "interrupt.hpp"
#include "options.hpp"
#include "progress_bar.hpp"
#include "run.hpp"

#include <cleave/base/error.hpp>

#include <exception>
#include <iostream>
#include <new>
#include <variant>

int main(int argc, char** argv) {
    const std::variant<Options, int> parsed = parse_command_line(argc, argv);
    if (const int* status = std::get_if<int>(&parsed)) return *status;
    const Options& options = std::get<Options>(parsed);

    Interrupt interrupt;
    ProgressBar bar(!options.quiet);
    try {
        const int status = run(options, interrupt, bar);
        std::cout.flush();
        if (std::cout) return status;
        std::cerr << "cleave: the standard output cannot be written\n";
    } catch (const cleave::Cancelled&) {
        bar.close();
        std::cerr << "cleave: cancelled\n";
        return interrupt.status();
    } catch (const cleave::Error& error) {
        bar.close();
        std::cerr << "cleave: " << error.what() << '\n';
    } catch (const std::bad_alloc&) {
        bar.close();
        std::cerr << "cleave: out of memory\n";
    } catch (const std::exception& error) {
        bar.close();
        std::cerr << "cleave: internal error: " << error.what() << '\n';
    }
    return 1;
}
