#include "core/mesh/ply_header.h"

#include "core/base/error.h"
#include "core/mesh/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

namespace normalscope::ply {

namespace {

std::optional<std::size_t> count_in(std::string_view text) {
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return n;
}

std::optional<Type> type_called(std::string_view name) {
    using enum Type::Kind;
    using Named = std::pair<std::string_view, Type>;
    constexpr std::array<Named, 18> kTypes{{{"char", {Signed, 1}},
                                            {"int8", {Signed, 1}},
                                            {"uchar", {Unsigned, 1}},
                                            {"uint8", {Unsigned, 1}},
                                            {"short", {Signed, 2}},
                                            {"int16", {Signed, 2}},
                                            {"ushort", {Unsigned, 2}},
                                            {"uint16", {Unsigned, 2}},
                                            {"int", {Signed, 4}},
                                            {"int32", {Signed, 4}},
                                            {"uint", {Unsigned, 4}},
                                            {"uint32", {Unsigned, 4}},
                                            {"int64", {Signed, 8}},
                                            {"uint64", {Unsigned, 8}},
                                            {"float", {Floating, 4}},
                                            {"float32", {Floating, 4}},
                                            {"double", {Floating, 8}},
                                            {"float64", {Floating, 8}}}};
    const auto* const found = std::ranges::find_if(kTypes, [&](const Named& n) { return is_word(name, n.first); });
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

Content content_called(std::string_view name) {
    if (is_word(name, "vertex")) return Content::Vertices;
    if (is_word(name, "face")) return Content::Faces;
    return is_word(name, "tristrips") ? Content::Strips : Content::Unknown;
}

Use use_of(const Property& property, Content content) {
    if (content == Content::Unknown) return Use::Skip;
    if (content != Content::Vertices) {
        const bool indices = is_word(property.name, "vertex_indices") || is_word(property.name, "vertex_index");
        return indices && property.list ? Use::Indices : Use::Skip;
    }
    constexpr std::array<std::string_view, 6> kNames{"x", "y", "z", "nx", "ny", "nz"};
    const auto* const at = std::ranges::find_if(kNames, [&](auto name) { return is_word(property.name, name); });
    if (at == kNames.end() || property.list) return Use::Skip;
    return static_cast<Use>(static_cast<int>(Use::X) + (at - kNames.begin()));
}

class HeaderReader {
public:
    HeaderReader(std::string_view text, const std::string& file) : words_(without_mark(text)), file_(file) {}

    Header run() {
        words_.skip_empty_lines();
        if (!is_word(words_.next(), "ply")) fail("is not a PLY file: it does not begin with \"ply\"");
        const bool lone_returns = words_.line_is_over() && ends_with_lone_return(words_.rest());
        words_.skip_line();
        for (; !words_.at_end(); words_.skip_line()) {
            const std::string_view key = words_.next();
            if (!is_word(key, "end_header")) {
                read_line(key);
                continue;
            }
            if (!has_format_) fail("its header names no format");
            require_surface();
            // What follows may be binary and begin with what looks like more of the line's end.
            header_.body = words_.rest();
            header_.body.remove_prefix(std::min(header_.body.find_first_not_of(" \t"), header_.body.size()));
            const bool pair = !lone_returns && header_.body.starts_with("\r\n");
            header_.body.remove_prefix(std::min<std::size_t>(pair ? 2 : 1, header_.body.size()));
            header_.body_line = words_.line() + 1;
            return std::move(header_);
        }
        fail("its header does not end");
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(file_ + ": " + what + "; export the mesh anew");
    }
    [[noreturn]] void fail_here(const std::string& what) const {
        fail("line " + std::to_string(words_.line()) + ": " + what);
    }
    static bool ends_with_lone_return(std::string_view end) {
        return end.starts_with('\r') && !end.starts_with("\r\n");
    }

    void read_line(std::string_view key) {
        if (is_word(key, "format")) {
            read_format(words_.next());
        } else if (is_word(key, "element")) {
            const std::string_view name = words_.next();
            const std::optional<std::size_t> count = count_in(words_.next());
            if (name.empty() || !count) fail_here("an element of its header has no name or no count");
            const Content content = content_called(name);
            if (content != Content::Unknown && std::ranges::count(header_.elements, content, &Element::content) > 0)
                fail_here("its header has the element " + in_quotes(name) + " twice");
            header_.elements.push_back({std::string(name), *count, content});
        } else if (is_word(key, "property")) {
            if (header_.elements.empty()) fail_here("its header has a property before any element");
            add_property(header_.elements.back());
        } else if (!key.empty() && !is_word(key, "comment") && !is_word(key, "obj_info")) {
            fail_here("its header has an unknown keyword " + in_quotes(key));
        }
    }
    void read_format(std::string_view name) {
        constexpr std::array<std::string_view, 3> kNames{"ascii", "binary_little_endian", "binary_big_endian"};
        const auto* const at = std::ranges::find_if(kNames, [&](auto known) { return is_word(name, known); });
        if (at == kNames.end())
            fail_here("its header has the unknown format " + in_quotes(name) +
                      "; known are ascii, binary_little_endian and binary_big_endian");
        header_.format = static_cast<Format>(at - kNames.begin());
        has_format_ = true;
    }
    void add_property(Element& element) {
        std::string_view type = words_.next();
        Property added{.list = is_word(type, "list")};
        if (added.list) {
            added.count_type = type_from(words_.next());
            if (added.count_type.kind == Type::Kind::Floating) fail_here("a list's count is not a whole number");
            type = words_.next();
        }
        added.type = type_from(type);
        added.name = words_.next();
        added.use = use_of(added, element.content);
        if (added.use != Use::Skip && element.has(added.use))
            fail_here("its header has the property " + in_quotes(added.name) + " twice");
        if (added.use == Use::Indices && added.type.kind == Type::Kind::Floating)
            fail_here("the numbers of vertices in " + in_quotes(added.name) + " are not whole numbers");
        element.properties.push_back(std::move(added));
    }
    Type type_from(std::string_view name) const {
        if (const auto type = type_called(name)) return *type;
        fail_here("its header has the unknown type " + in_quotes(name));
    }
    void require_surface() const {
        const auto vertices = std::ranges::find(header_.elements, Content::Vertices, &Element::content);
        if (vertices == header_.elements.end() || !vertices->has(Use::X) || !vertices->has(Use::Y) ||
            !vertices->has(Use::Z))
            fail("its header has no vertices with x, y and z");
        if (std::ranges::none_of(header_.elements, [](const Element& e) { return e.count > 0 && e.has(Use::Indices); }))
            throw InputError(file_ + ": has no faces, only points; export it as a surface");
    }

    Words words_;
    const std::string& file_;
    Header header_;
    bool has_format_ = false;
};

}  // namespace

bool Element::has(Use use) const { return std::ranges::count(properties, use, &Property::use) > 0; }
bool Element::has_lists() const { return std::ranges::count(properties, true, &Property::list) > 0; }

Header read_header(std::string_view text, const std::string& file) { return HeaderReader(text, file).run(); }

}  // namespace normalscope::ply
