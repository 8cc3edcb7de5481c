// SPDX-License-Identifier: Apache-2.0
/// Images and PNG files, so that examples draw their pictures without any library.
///
/// The encoder chooses a filter for each row by the least sum of absolute differences and compresses by matches in a
/// hash table, written with the fixed Huffman code of DEFLATE (RFC 1950, 1951, 2083).
#ifndef CLEAVE_EXAMPLES_SUPPORT_PNG_HPP
#define CLEAVE_EXAMPLES_SUPPORT_PNG_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace picture {

/// Eight bits of red, green and blue a pixel, rows from the top.
struct Image {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> rgb;

    Image() = default;
    Image(std::size_t w, std::size_t h) : width(w), height(h), rgb(3 * w * h) {}

    [[nodiscard]] std::uint8_t* pixel(std::size_t x, std::size_t y) { return rgb.data() + 3 * (y * width + x); }
};

namespace detail {

inline void append_big_endian(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>((value >> shift) & 0xffU);
}

[[nodiscard]] inline std::uint32_t crc(std::string_view bytes) {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> t{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            t[i] = i;
            for (int k = 0; k < 8; ++k) t[i] = (t[i] >> 1) ^ ((t[i] & 1U) != 0 ? 0xedb88320U : 0U);
        }
        return t;
    }();
    std::uint32_t c = 0xffffffffU;
    for (const char byte : bytes) c = table[(c ^ static_cast<unsigned char>(byte)) & 0xffU] ^ (c >> 8);
    return ~c;
}

inline void append_chunk(std::string& out, std::string_view type, std::string_view data) {
    append_big_endian(out, static_cast<std::uint32_t>(data.size()));
    const std::string body = std::string(type) + std::string(data);
    out += body;
    append_big_endian(out, crc(body));
}

/// Bits, the least significant first, as DEFLATE packs them.
class BitWriter {
public:
    void bits(std::uint32_t value, int count) {
        buffer_ |= std::uint64_t{value} << filled_;
        for (filled_ += count; filled_ >= 8; filled_ -= 8, buffer_ >>= 8) out_ += static_cast<char>(buffer_ & 0xffU);
    }
    /// A Huffman code: these start with their most significant bit.
    void code(std::uint32_t value, int count) {
        for (int i = count - 1; i >= 0; --i) bits((value >> i) & 1U, 1);
    }
    [[nodiscard]] std::string take() {
        if (filled_ > 0) bits(0, 8 - filled_);
        return std::move(out_);
    }

private:
    std::string out_;
    std::uint64_t buffer_ = 0;
    int filled_ = 0;
};

/// Symbols of the fixed code: literals 0-255, end 256, lengths 257-287.
inline void put_symbol(BitWriter& out, std::uint32_t symbol) {
    if (symbol < 144) {
        out.code(0x30 + symbol, 8);
    } else if (symbol < 256) {
        out.code(0x190 + symbol - 144, 9);
    } else if (symbol < 280) {
        out.code(symbol - 256, 7);
    } else {
        out.code(0xc0 + symbol - 280, 8);
    }
}

/// The class of a length or distance: from 4 (8 for lengths) classes on, each power of two is cut into `1 << cut`.
inline void put_match(BitWriter& out, std::uint32_t length, std::uint32_t distance) {
    if (length == 258) {
        put_symbol(out, 285);
    } else {
        const std::uint32_t n = length - 3;
        int extra = 0;
        while ((n >> extra) >= 8) ++extra;
        put_symbol(out, 257 + static_cast<std::uint32_t>(4 * extra) + (n >> extra));
        out.bits(n & ((1U << extra) - 1), extra);
    }
    const std::uint32_t n = distance - 1;
    int extra = 0;
    while ((n >> extra) >= 4) ++extra;
    out.code(static_cast<std::uint32_t>(2 * extra) + (n >> extra), 5);
    out.bits(n & ((1U << extra) - 1), extra);
}

/// A zlib stream of one DEFLATE block.
[[nodiscard]] inline std::string compress(const std::vector<std::uint8_t>& data) {
    constexpr std::size_t window = 32768, longest = 258, none = static_cast<std::size_t>(-1);
    BitWriter out;
    out.bits(1, 1);  // the last block
    out.bits(1, 2);  // fixed code
    std::vector<std::size_t> head(1 << 15, none), previous(window, none);
    const auto hash = [&](std::size_t i) {
        const std::uint32_t three = data[i] | std::uint32_t{data[i + 1]} << 8 | std::uint32_t{data[i + 2]} << 16;
        return (three * 0x9e3779b1U) >> 17;
    };
    const auto enter = [&](std::size_t i) {
        if (i + 2 >= data.size()) return;
        previous[i % window] = head[hash(i)];
        head[hash(i)] = i;
    };
    for (std::size_t i = 0; i < data.size();) {
        std::size_t best = 0, from = 0;
        const std::size_t limit = std::min(longest, data.size() - i);
        if (limit >= 3) {
            int tries = 48;
            for (std::size_t j = head[hash(i)]; j != none && i - j < window && tries-- > 0; j = previous[j % window]) {
                std::size_t n = 0;
                while (n < limit && data[i + n] == data[j + n]) ++n;
                if (n > best) {
                    best = n;
                    from = j;
                }
                if (n == limit || previous[j % window] >= j) break;
            }
        }
        if (best >= 3) {
            put_match(out, static_cast<std::uint32_t>(best), static_cast<std::uint32_t>(i - from));
            for (const std::size_t end = i + best; i < end; ++i) enter(i);
        } else {
            put_symbol(out, data[i]);
            enter(i++);
        }
    }
    put_symbol(out, 256);
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : data) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    std::string stream("\x78\x9c");
    stream += out.take();
    append_big_endian(stream, b << 16 | a);
    return stream;
}

/// One row under each filter of PNG; the one whose bytes are smallest, taken as signed, compresses best as a rule.
inline void append_filtered_row(std::vector<std::uint8_t>& out, const Image& image, std::size_t y) {
    const std::size_t n = 3 * image.width;
    const std::uint8_t* const row = image.rgb.data() + y * n;
    const auto at = [](const std::uint8_t* r, std::size_t i) { return static_cast<int>(r == nullptr ? 0 : r[i]); };
    const std::uint8_t* const above = y == 0 ? nullptr : row - n;
    std::vector<std::uint8_t> best, candidate(n);
    long least = -1;
    std::uint8_t chosen = 0;
    for (std::uint8_t filter = 0; filter < 5; ++filter) {
        long sum = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const int left = i < 3 ? 0 : at(row, i - 3), up = at(above, i), corner = i < 3 ? 0 : at(above, i - 3);
            int guess = 0;
            if (filter == 1) guess = left;
            if (filter == 2) guess = up;
            if (filter == 3) guess = (left + up) / 2;
            if (filter == 4) {
                const int p = left + up - corner;
                const int dl = std::abs(p - left), du = std::abs(p - up), dc = std::abs(p - corner);
                guess = dl <= du && dl <= dc ? left : (du <= dc ? up : corner);
            }
            candidate[i] = static_cast<std::uint8_t>(at(row, i) - guess);
            sum += candidate[i] < 128 ? candidate[i] : 256 - candidate[i];
        }
        if (least < 0 || sum < least) {
            least = sum;
            chosen = filter;
            best = candidate;
        }
    }
    out.push_back(chosen);
    out.insert(out.end(), best.begin(), best.end());
}

}  // namespace detail

/// The bytes of a PNG file.
[[nodiscard]] inline std::string to_png(const Image& image) {
    std::string png("\x89PNG\r\n\x1a\n");
    std::string header;
    detail::append_big_endian(header, static_cast<std::uint32_t>(image.width));
    detail::append_big_endian(header, static_cast<std::uint32_t>(image.height));
    header += std::string_view("\x08\x02\x00\x00\x00", 5);  // 8 bits a channel, RGB, no interlacing
    detail::append_chunk(png, "IHDR", header);
    detail::append_chunk(png, "sRGB", std::string_view("\0", 1));
    std::vector<std::uint8_t> rows;
    rows.reserve(image.rgb.size() + image.height);
    for (std::size_t y = 0; y < image.height; ++y) detail::append_filtered_row(rows, image, y);
    detail::append_chunk(png, "IDAT", detail::compress(rows));
    detail::append_chunk(png, "IEND", {});
    return png;
}

}  // namespace picture

#endif
