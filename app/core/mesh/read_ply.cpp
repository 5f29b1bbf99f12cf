#include "core/base/error.h"
#include "core/mesh/polygons.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>

namespace normalscope {

namespace {

// assimp believes what a PLY file claims: a count of four billion allocates as much. So the file is walked through
// first, and every claim held against the bytes that are there.

struct Property {
    std::string name;
    std::size_t size = 0;        // in bytes, of the value or of each of the list's values
    std::size_t count_size = 0;  // of the list's count; 0: not a list
};
struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
    bool has(std::string_view property) const { return std::ranges::count(properties, property, &Property::name) > 0; }
};
enum class Format { Ascii, LittleEndian, BigEndian };

class PlyCheck {
public:
    PlyCheck(std::string_view bytes, const std::string& file) : rest_(bytes), file_(file) {}

    void run() {
        read_header();
        require_surface();
        for (const Element& element : elements_) {
            if (element.count > rest_.size()) cut_short(element);
            if (format_ == Format::Ascii)
                walk_ascii(element);
            else
                walk_binary(element);
        }
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(file_ + ": " + what + "; export the mesh anew");
    }
    [[noreturn]] void cut_short(const Element& element) const {
        fail("ends before its " + std::to_string(element.count) + " entries of \"" + element.name + "\" do");
    }

    std::optional<std::string_view> line() {
        if (rest_.empty()) return std::nullopt;
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        if (text.ends_with('\r')) text.remove_suffix(1);
        return text;
    }
    static std::string_view word(std::string_view& text) {
        const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
        text.remove_prefix(begin);
        const std::string_view found = text.substr(0, std::min(text.find_first_of(" \t"), text.size()));
        text.remove_prefix(found.size());
        return found;
    }
    static std::optional<std::size_t> count_from(std::string_view text) {
        std::size_t n = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
        if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
        return n;
    }
    std::size_t size_of_type(std::string_view type) const {
        using Size = std::pair<std::string_view, std::size_t>;
        constexpr std::array<Size, 16> kSizes{{{"char", 1},
                                               {"int8", 1},
                                               {"uchar", 1},
                                               {"uint8", 1},
                                               {"short", 2},
                                               {"int16", 2},
                                               {"ushort", 2},
                                               {"uint16", 2},
                                               {"int", 4},
                                               {"int32", 4},
                                               {"uint", 4},
                                               {"uint32", 4},
                                               {"float", 4},
                                               {"float32", 4},
                                               {"double", 8},
                                               {"float64", 8}}};
        const auto found = std::ranges::find(kSizes, type, &Size::first);
        if (found == kSizes.end()) fail("its header has an unknown type \"" + std::string(type.substr(0, 20)) + "\"");
        return found->second;
    }

    void read_header() {
        std::optional<std::string_view> text = line();
        if (!text || *text != "ply") fail("is no PLY file: it does not begin with \"ply\"");
        bool has_format = false;
        while ((text = line())) {
            const std::string_view key = word(*text);
            if (key == "end_header") {
                if (!has_format) fail("its header names no format");
                return;
            }
            if (key == "format") {
                const std::string_view format = word(*text);
                has_format = true;
                if (format == "ascii")
                    format_ = Format::Ascii;
                else if (format == "binary_little_endian")
                    format_ = Format::LittleEndian;
                else if (format == "binary_big_endian")
                    format_ = Format::BigEndian;
                else
                    fail("its header names an unknown format");
            } else if (key == "element") {
                const std::string_view element = word(*text);
                const std::optional<std::size_t> count = count_from(word(*text));
                if (element.empty() || !count) fail("its header has an element without a name or a count");
                elements_.push_back({std::string(element.substr(0, 40)), *count, {}});
            } else if (key == "property") {
                if (elements_.empty()) fail("its header has a property before any element");
                Property added = property(*text);
                if (elements_.back().has(added.name)) fail("its header has a property twice");
                elements_.back().properties.push_back(std::move(added));
            } else if (!key.empty() && key != "comment" && key != "obj_info") {
                // assimp could take it for something, and then read counts of billions where there are none.
                fail("its header has an unknown line");
            }
        }
        fail("its header does not end");
    }
    Property property(std::string_view text) const {
        std::string_view type = word(text);
        Property result;
        if (type == "list") {
            result.count_size = size_of_type(word(text));
            type = word(text);
        }
        result.size = size_of_type(type);
        result.name = word(text);
        return result;
    }
    void require_surface() const {
        const auto vertices = std::ranges::find(elements_, "vertex", &Element::name);
        if (vertices == elements_.end() || !vertices->has("x") || !vertices->has("y") || !vertices->has("z"))
            fail("its header has no vertices with x, y and z");
        for (const Element& element : elements_) {
            const bool faces = element.name == "face" || element.name == "tristrips";
            // assimp takes the first of a list's values where it expects a single one, even of an empty list.
            for (const Property& p : element.properties)
                if (p.count_size > 0 &&
                    !(faces && (p.name.starts_with("vertex_ind") || p.name.starts_with("texcoord"))))
                    fail("has a list \"" + p.name + "\" in \"" + element.name + "\", which is not understood");
        }
        const bool surface = std::ranges::any_of(elements_, [](const Element& e) {
            return (e.name == "face" || e.name == "tristrips") && e.count > 0 &&
                   (e.has("vertex_indices") || e.has("vertex_index"));
        });
        if (!surface) throw InputError(file_ + ": has no faces, only points; export it as a surface");
    }

    void walk_ascii(const Element& element) {
        for (std::size_t i = 0; i < element.count; ++i) {
            std::optional<std::string_view> text = line();
            if (!text) cut_short(element);
            for (const Property& p : element.properties) {
                std::size_t values = 1;
                if (p.count_size > 0) {
                    const std::optional<std::size_t> count = count_from(word(*text));
                    if (!count || *count > text->size()) bad_entry(element, i);
                    values = *count;
                }
                for (; values > 0; --values) {
                    const std::string_view value = word(*text);
                    if (value.empty() || value.find_first_not_of("0123456789+-.eE") != value.npos)
                        bad_entry(element, i);
                }
            }
        }
    }
    [[noreturn]] void bad_entry(const Element& element, std::size_t i) const {
        fail("entry " + std::to_string(i + 1) + " of \"" + element.name +
             "\" is not the numbers that the header announces");
    }

    void walk_binary(const Element& element) {
        std::size_t fixed = 0;
        bool lists = false;
        for (const Property& p : element.properties) {
            fixed += p.count_size > 0 ? 0 : p.size;
            lists = lists || p.count_size > 0;
        }
        if (!lists) {  // the count is at most the number of bytes, so the product cannot overflow
            if (element.count * fixed > rest_.size()) cut_short(element);
            rest_.remove_prefix(element.count * fixed);
            return;
        }
        const auto skip = [&](std::size_t n) {
            if (n > rest_.size()) cut_short(element);
            rest_.remove_prefix(n);
        };
        for (std::size_t i = 0; i < element.count; ++i)
            for (const Property& p : element.properties) {
                if (p.count_size == 0) {
                    skip(p.size);
                    continue;
                }
                if (p.count_size > rest_.size()) cut_short(element);
                std::size_t count = 0;
                for (std::size_t k = 0; k < p.count_size; ++k) {
                    const std::size_t from = format_ == Format::BigEndian ? k : p.count_size - 1 - k;
                    count = count << 8 | static_cast<unsigned char>(rest_[from]);
                }
                skip(p.count_size);
                if (count > rest_.size()) cut_short(element);  // also what a negative count looks like
                skip(count * p.size);
            }
    }

    std::string_view rest_;
    const std::string& file_;
    Format format_ = Format::Ascii;
    std::vector<Element> elements_;
};

}  // namespace

Polygons read_ply(std::string_view bytes, const std::string& file) {
    PlyCheck(bytes, file).run();
    return import_by_assimp(bytes, "ply", file);
}

}  // namespace normalscope
