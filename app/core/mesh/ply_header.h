#pragma once

// What a PLY file's header announces. Only read_ply.cpp includes this.
// Turk, "The PLY polygon file format", 1994.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope::ply {

enum class Format { Ascii, LittleEndian, BigEndian };

/// A kind of number.
struct Type {
    enum class Kind { Signed, Unsigned, Floating } kind;
    std::size_t size;  ///< in bytes
};

/// What a property or an element is to us; all else is skipped.
enum class Use {
    Skip,
    X,  ///< up to Nz: of a vertex
    Y,
    Z,
    Nx,
    Ny,
    Nz,
    Indices  ///< a list: the vertices of a face or a strip
};
enum class Content { Unknown, Vertices, Faces, Strips };

struct Property {
    std::string name;
    Type type;
    bool list;
    Type count_type;  ///< of a list
    Use use = Use::Skip;
};
struct Element {
    std::string name;
    std::size_t count = 0;
    Content content = Content::Unknown;
    std::vector<Property> properties{};

    bool has(Use use) const;
    bool has_lists() const;
};
struct Header {
    Format format = Format::Ascii;
    std::vector<Element> elements{};
    std::string_view body{};    ///< what follows the header
    std::size_t body_line = 0;  ///< where that begins, counted from 1
};

/// Throws InputError where it is none, or announces no surface.
Header read_header(std::string_view text, const std::string& file);

}  // namespace normalscope::ply
