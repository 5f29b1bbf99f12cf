#include "core/base/error.h"
#include "core/mesh/ply_header.h"
#include "core/mesh/polygons.h"
#include "core/mesh/words.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>
#include <utility>

namespace normalscope {

namespace {

using ply::Content;
using ply::Element;
using ply::Property;
using ply::Type;
using ply::Use;

/// The numbers of an ASCII file, from its body on. An entry begins in a line of its own, and may take several. Each read
/// is false where what follows is not what was asked for.
class Text {
public:
    explicit Text(const ply::Header& header) : words_(header.body), first_line_(header.body_line) {}

    bool at_end() {
        words_.skip_empty_lines();
        return words_.at_end();
    }
    std::size_t left() const { return words_.rest().size(); }
    std::string where() const { return "line " + std::to_string(first_line_ + words_.line() - 1) + ": "; }

    bool number(const Type&, double& to) {
        if (!to_next_word()) return false;
        if (words_.number(to)) return true;
        // What is no number ("nan", "-1.#IND") is one that a normal may lack, and a position must not.
        to = std::numeric_limits<double>::quiet_NaN();
        words_.next();
        return true;
    }
    bool whole(const Type&, std::int64_t& to) {
        if (!to_next_word()) return false;
        std::string_view word = words_.next();
        constexpr std::size_t kMostDigits = 18;
        const bool negative = word.starts_with('-');
        if (negative || word.starts_with('+')) word.remove_prefix(1);
        if (word.empty() || word.size() > kMostDigits) return false;
        to = 0;
        for (const char c : word) {
            if (c < '0' || c > '9') return false;
            to = 10 * to + (c - '0');
        }
        if (negative) to = -to;
        return true;
    }
    bool skip(const Type&, std::size_t count) {
        for (; count > 0 && to_next_word(); --count) words_.next();
        return count == 0;
    }
    bool end_entry() { return words_.line_is_over(); }
    bool skip_entries(const Element&) { return false; }

    /// Whether a read was false because the file ends.
    bool cut_short() const { return cut_short_; }

private:
    bool to_next_word() {
        words_.skip_empty_lines();
        cut_short_ = words_.at_end();
        return !cut_short_;
    }

    Words words_;
    std::size_t first_line_;
    bool cut_short_ = false;
};

/// The same of a binary file.
class Binary {
public:
    Binary(std::string_view body, std::endian order) : rest_(body), turned_(order != std::endian::native) {}

    bool at_end() const { return rest_.empty(); }
    std::size_t left() const { return rest_.size(); }
    std::string where() const { return ""; }

    bool number(const Type& type, double& to) {
        if (type.kind == Type::Kind::Floating) return type.size == 4 ? take<float>(to) : take<double>(to);
        std::int64_t value = 0;
        if (!whole(type, value)) return false;
        to = static_cast<double>(value);
        return true;
    }
    bool whole(const Type& type, std::int64_t& to) {
        const bool is_signed = type.kind == Type::Kind::Signed;
        switch (type.size) {
            case 1: return is_signed ? take<std::int8_t>(to) : take<std::uint8_t>(to);
            case 2: return is_signed ? take<std::int16_t>(to) : take<std::uint16_t>(to);
            case 4: return is_signed ? take<std::int32_t>(to) : take<std::uint32_t>(to);
            default: return take<std::int64_t>(to);  // beyond its half it is negative, and no index of a file
        }
    }
    bool skip(const Type& type, std::size_t count) {
        cut_short_ = count > rest_.size() / type.size;
        if (cut_short_) return false;
        rest_.remove_prefix(count * type.size);
        return true;
    }
    bool end_entry() const { return true; }
    bool cut_short() const { return cut_short_; }
    /// All of an element's entries, where they are of one size; false where they are not, or there are not as many.
    bool skip_entries(const Element& element) {
        std::size_t size = 0;
        for (const Property& p : element.properties) size += p.type.size;
        if (element.has_lists() || (size > 0 && element.count > rest_.size() / size)) return false;
        rest_.remove_prefix(element.count * size);
        return true;
    }

private:
    template <class T, class To>
    bool take(To& to) {
        cut_short_ = rest_.size() < sizeof(T);
        if (cut_short_) return false;
        std::array<char, sizeof(T)> bytes;
        std::copy_n(rest_.begin(), sizeof(T), bytes.begin());
        if (turned_) std::ranges::reverse(bytes);
        to = static_cast<To>(+std::bit_cast<T>(bytes));  // +: a char, too, is a number
        rest_.remove_prefix(sizeof(T));
        return true;
    }

    std::string_view rest_;
    bool turned_, cut_short_ = false;
};

template <class Source>
class PlyReader {
public:
    PlyReader(Source source, const ply::Header& header, const std::string& file)
        : source_(std::move(source)), header_(header), file_(file) {
        polygons_.faces.emplace_back();
        for (const Element& element : header.elements)
            if (element.content == Content::Vertices) vertices_ = &element;
        normals_ = vertices_->has(Use::Nx) && vertices_->has(Use::Ny) && vertices_->has(Use::Nz);
    }

    Polygons run() {
        for (const Element& element : header_.elements) read(element);
        if (!source_.at_end()) polygons_.note = "what follows its last element is left out";
        return std::move(polygons_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(file_ + ": " + source_.where() + what + "; repair or export the mesh anew");
    }
    static std::string entry(const Element& element, std::size_t i) {
        return "entry " + std::to_string(i + 1) + " of " + in_quotes(element.name);
    }
    [[noreturn]] void fail_at_end(const Element& element) const {
        throw InputError(file_ + ": ends before its " + std::to_string(element.count) + " entries of " +
                         in_quotes(element.name) + " do; export the mesh anew");
    }
    // Why an entry could not be read.
    [[noreturn]] void fail_to_read(const Element& element, std::size_t i) {
        if (source_.cut_short()) fail_at_end(element);
        fail(entry(element, i) + " is not the numbers that the header announces");
    }

    void read(const Element& element) {
        if (element.properties.empty()) return;  // then its entries take no place
        if (element.count > source_.left()) fail_at_end(element);
        if (element.content == Content::Vertices) {
            polygons_.positions.reserve(element.count);
            if (normals_) polygons_.normals.reserve(element.count);
        } else if (!element.has(Use::Indices) && source_.skip_entries(element)) {
            return;
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            for (const Property& property : element.properties)
                if (!(property.list ? read_list(element, property, i) : read_value(property))) fail_to_read(element, i);
            if (!source_.end_entry()) fail(entry(element, i) + " has more numbers than the header announces");
            if (element.content == Content::Vertices) add_vertex(i);
        }
    }
    bool read_value(const Property& property) {
        if (property.use == Use::Skip) return source_.skip(property.type, 1);
        return source_.number(property.type, vertex_[static_cast<std::size_t>(property.use)]);
    }
    bool read_list(const Element& element, const Property& property, std::size_t entry) {
        std::int64_t count = 0;
        if (!source_.whole(property.count_type, count) || count < 0) return false;
        const auto size = static_cast<std::size_t>(count);
        if (size > source_.left()) return false;  // each takes a byte at least
        if (property.use == Use::Skip) return source_.skip(property.type, size);
        indices_.clear();
        for (std::size_t i = 0; i < size; ++i) {
            std::int64_t index = 0;
            if (!source_.whole(property.type, index)) return false;
            check_index(element, index, entry);
            indices_.push_back(static_cast<std::int32_t>(index));
        }
        if (element.content == Content::Strips)
            add_strips();
        else
            add_face(indices_);
        return true;
    }
    void check_index(const Element& element, std::int64_t index, std::size_t entry) const {
        const bool restart = element.content == Content::Strips && index == -1;
        if (restart || (index >= 0 && static_cast<std::uint64_t>(index) < vertices_->count)) return;
        fail(element.name + " " + std::to_string(entry + 1) + " refers to a vertex that does not exist (there are " +
             std::to_string(vertices_->count) + ")");
    }

    void add_vertex(std::size_t i) {
        const auto at = [&](Use use) { return vertex_[static_cast<std::size_t>(use)]; };
        const glm::dvec3 position(at(Use::X), at(Use::Y), at(Use::Z));
        if (glm::any(glm::isnan(position)))
            fail("vertex " + std::to_string(i + 1) + " has a coordinate that is not a number");
        polygons_.positions.push_back(position);
        if (normals_) polygons_.normals.emplace_back(at(Use::Nx), at(Use::Ny), at(Use::Nz));
    }
    void add_face(std::span<const std::int32_t> vertices) {
        Polygons::Block& block = polygons_.faces.back();
        for (const std::int32_t v : vertices) block.corners.push_back({v, normals_ ? v : Polygons::kNone});
        block.sizes.push_back(static_cast<std::uint32_t>(vertices.size()));
    }
    // Each vertex makes a triangle with the two before it, which turns as the first one does; −1 ends a strip. Two equal
    // corners only lead from one part of a strip to the next.
    void add_strips() {
        for (auto begin = indices_.begin(); begin != indices_.end();) {
            const auto end = std::find(begin, indices_.end(), -1);
            for (auto at = begin; end - at >= 3; ++at) {
                std::array<std::int32_t, 3> corners{at[0], at[1], at[2]};
                if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
                if ((at - begin) % 2 == 1) std::swap(corners[0], corners[1]);
                add_face(corners);
            }
            begin = end == indices_.end() ? end : end + 1;
        }
    }

    Source source_;
    const ply::Header& header_;
    const std::string& file_;
    const Element* vertices_ = nullptr;
    bool normals_ = false;
    std::array<double, static_cast<std::size_t>(Use::Indices)> vertex_{};  // by Use
    std::vector<std::int32_t> indices_;
    Polygons polygons_;
};

}  // namespace

Polygons read_ply(std::string_view bytes, const std::string& file) {
    const ply::Header header = ply::read_header(bytes, file);
    if (header.format == ply::Format::Ascii) return PlyReader(Text(header), header, file).run();
    const std::endian order = header.format == ply::Format::BigEndian ? std::endian::big : std::endian::little;
    return PlyReader(Binary(header.body, order), header, file).run();
}

}  // namespace normalscope
