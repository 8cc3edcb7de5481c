// SPDX-License-Identifier: Apache-2.0
/// What faces of different operands have in common, as it is listed for each of them.
#ifndef CLEAVE_SETOP_CONTACT_RECORDS_HPP
#define CLEAVE_SETOP_CONTACT_RECORDS_HPP

#include <cleave/setop/face_contact.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A common segment of two faces of different operands; see `ContactSegment`. Index 0 or 1 is the face.
struct CommonSegment {
    std::array<std::uint32_t, 2> operand;  ///< ascending
    std::array<std::uint32_t, 2> face;
    std::array<std::uint32_t, 2> corner;  ///< of the face's edge that contains it, or `no_id`
    PointId from, to;
    std::array<std::uint8_t, 2> sides;
    std::uint32_t edge_of;  ///< coplanar faces: the one (0, 1) along whose edge it runs; `no_id` for others
    bool opposite;          ///< coplanar: whether they face opposite ways

    /// The least feature of a face that contains the whole segment.
    [[nodiscard]] Feature feature(std::size_t of) const {
        return corner[of] == no_id ? Feature{} : Feature{Feature::Kind::edge, corner[of]};
    }
};

/// A common segment as one of its faces sees it. Where the other face is coplanar, `up_down` is 0, else `left_right`
/// is. Directed so that a face that is not coplanar has its minus side on the left.
struct SegmentRecord {
    std::uint32_t face;
    std::uint32_t corner;  ///< of the face's edge that contains it, or `no_id`
    PointId from, to;
    std::uint32_t operand;    ///< the other face's
    std::uint32_t other;      ///< the other face
    std::uint8_t up_down;     ///< 1: the other face is beneath, 2: above
    std::uint8_t left_right;  ///< coplanar; 1: the other face is on the left, 2: on the right
    bool opposite;            ///< coplanar: whether it faces the other way
};

/// A common point as one of its faces sees it.
struct PointContact {
    std::uint32_t face;
    Feature of_face;
    Feature of_other;
    PointId point;
    std::uint32_t operand;  ///< the other face's
    std::uint32_t other;    ///< the other face
};

/// The records of one face.
struct FaceRecords {
    std::span<const SegmentRecord> segments;
    std::span<const PointContact> points;
};

/// The records of faces of one operand, asked for in ascending order. Requires: they ascend by face.
class RecordWalk {
public:
    RecordWalk(std::span<const SegmentRecord> segments, std::span<const PointContact> points)
        : segments_(segments), points_(points) {}

    FaceRecords of(std::uint32_t face) { return {take(segments_, face), take(points_, face)}; }

private:
    template <class Record>
    static std::span<const Record> take(std::span<const Record>& rest, std::uint32_t face) {
        std::size_t skip = 0;
        while (skip < rest.size() && rest[skip].face < face) ++skip;
        std::size_t n = skip;
        while (n < rest.size() && rest[n].face == face) ++n;
        const std::span<const Record> found = rest.subspan(skip, n - skip);
        rest = rest.subspan(n);
        return found;
    }

    std::span<const SegmentRecord> segments_;
    std::span<const PointContact> points_;
};

CLEAVE_END_NAMESPACE

#endif
