#include "core/base/error.h"
#include "core/mesh/polygons.h"
#include "core/mesh/words.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

namespace normalscope {

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;  // bytes of a binary file: 80 of comment and the count; each facet

// So many bytes as a number, the least first.
std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t k = 4; k-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + k]);
    return number;
}

/// Facets with their corners. STL names no vertices: every facet brings its three corners. Those at exactly the same
/// place become one, so that neighbours are known and normals can be smooth.
class Facets {
public:
    explicit Facets(std::size_t likely) {
        polygons_.lacking = "vertex normals";
        polygons_.faces.emplace_back();
        grow(std::bit_ceil(2 * likely + 1));  // a closed surface has half as many vertices as triangles
    }
    void add(const std::array<glm::dvec3, 3>& corners) {
        for (const glm::dvec3& p : corners)
            // Facets' normals only repeat what the corners say, and are often wrong or zero.
            polygons_.faces.back().corners.push_back({vertex_at(p), Polygons::kNone});
        polygons_.faces.back().sizes.push_back(3);
    }
    std::size_t count() const { return polygons_.faces.back().sizes.size(); }
    Polygons take(const std::string& note) {
        polygons_.note = note;
        return std::move(polygons_);
    }

private:
    static constexpr std::int32_t kFree = -1;

    std::int32_t vertex_at(const glm::dvec3& given) {
        const glm::dvec3 p = given + 0.0;  // −0 becomes 0, which equals it but has other bits
        std::int32_t& slot = slot_of(p);
        if (slot != kFree) return slot;
        const auto vertex = static_cast<std::int32_t>(polygons_.positions.size());
        slot = vertex;
        polygons_.positions.push_back(p);
        if (2 * polygons_.positions.size() > table_.size()) grow(2 * table_.size());
        return vertex;
    }
    // Where it stands in the table, or would.
    std::int32_t& slot_of(const glm::dvec3& p) {
        std::uint64_t hash = 0;
        for (const double x : {p.x, p.y, p.z}) {  // splitmix64's mixing steps
            hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0xBF58476D1CE4E5B9u;
            hash ^= hash >> 31;
        }
        auto slot = static_cast<std::size_t>(hash & (table_.size() - 1));
        while (table_[slot] != kFree && polygons_.positions[static_cast<std::size_t>(table_[slot])] != p)
            slot = (slot + 1) & (table_.size() - 1);
        return table_[slot];
    }
    void grow(std::size_t slots) {
        table_.assign(slots, kFree);
        for (std::size_t i = 0; i < polygons_.positions.size(); ++i)
            slot_of(polygons_.positions[i]) = static_cast<std::int32_t>(i);
    }

    Polygons polygons_;
    std::vector<std::int32_t> table_;  // open addressing; a power of two
};

Polygons read_binary(std::string_view bytes, const std::string& file) {
    const std::size_t count = number_at(bytes, kHeader - 4);
    Facets facets(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<glm::dvec3, 3> corners;
        for (std::size_t k = 0; k < 9; ++k)  // behind the facet's normal
            corners[k / 3][static_cast<int>(k % 3)] =
                std::bit_cast<float>(number_at(bytes, kHeader + i * kFacet + 12 + 4 * k));
        for (const glm::dvec3& p : corners)
            if (glm::any(glm::isnan(p)) || glm::any(glm::isinf(p)))
                throw InputError(file + ": facet " + std::to_string(i + 1) +
                                 " has a coordinate that is not a number; repair or export the mesh anew");
        facets.add(corners);
    }
    return facets.take(bytes.size() > kHeader + count * kFacet ? "what follows its last facet is left out" : "");
}

/// ASCII: solid NAME, then facets as "facet normal …, outer loop, vertex x y z (three times), endloop, endfacet", then
/// endsolid NAME; maybe several times. What stands behind "solid", "facet" and "endsolid" in their line says nothing.
class TextReader {
public:
    TextReader(std::string_view text, const std::string& file)
        : words_(text), file_(file), facets_(text.size() / 250) {}

    Polygons run() {
        for (words_.skip_empty_lines(); !words_.at_end(); words_.skip_empty_lines()) {
            if (!is_word(words_.next(), "solid")) return facets_.take("what follows its last solid is left out");
            words_.skip_line();
            read_solid();
        }
        return facets_.take("");
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(file_ + ": line " + std::to_string(words_.line()) + ": " + what +
                         "; repair or export the mesh anew");
    }
    std::string_view next() {
        words_.skip_empty_lines();
        if (words_.at_end()) throw InputError(file_ + ": ends before its \"endsolid\"; export the mesh anew");
        return words_.next();
    }
    void expect(std::string_view keyword) {
        if (const std::string_view word = next(); !is_word(word, keyword))
            fail("has " + in_quotes(word) + " where " + in_quotes(keyword) + " should be");
    }
    void read_solid() {
        for (std::string_view word = next(); !is_word(word, "endsolid"); word = next()) {
            if (!is_word(word, "facet")) fail("has " + in_quotes(word) + " where \"facet\" or \"endsolid\" should be");
            read_facet();
        }
        words_.skip_line();
    }
    void read_facet() {
        words_.skip_line();
        expect("outer");
        expect("loop");
        std::array<glm::dvec3, 3> corners;
        std::size_t count = 0;
        for (std::string_view word = next(); !is_word(word, "endloop"); word = next(), ++count) {
            if (!is_word(word, "vertex")) fail("has " + in_quotes(word) + " where \"vertex\" or \"endloop\" should be");
            if (count == corners.size()) fail("is a facet's fourth vertex, and a facet has three");
            if (!words_.numbers(corners[count])) fail("a vertex needs three numbers");
        }
        if (count < corners.size())
            fail("ends a facet of " + std::to_string(count) + " vertices, and a facet has three");
        expect("endfacet");
        facets_.add(corners);
    }

    Words words_;
    const std::string& file_;
    Facets facets_;
};

bool begins_as_text(std::string_view bytes) {
    Words words(bytes);
    words.skip_empty_lines();
    return is_word(words.next(), "solid") && bytes.find('\0') == bytes.npos;
}

}  // namespace

Polygons read_stl(std::string_view bytes, const std::string& file) {
    // A binary file's comment may begin with "solid" too, so its length decides before its first word.
    const std::uint64_t claimed = bytes.size() < kHeader ? 0 : number_at(bytes, kHeader - 4);
    const std::uint64_t needed = kHeader + kFacet * claimed;
    if (bytes.size() != needed) {
        if (const std::string_view text = without_mark(bytes); begins_as_text(text))
            return TextReader(text, file).run();
        if (bytes.size() < kHeader)
            throw InputError(file +
                             ": is too short for an STL file and does not begin with \"solid\"; export the mesh anew");
        if (bytes.size() < needed || claimed == 0)
            throw InputError(file + ": announces " + std::to_string(claimed) + " facets, which is not what its " +
                             std::to_string(bytes.size()) +
                             " bytes hold, so it is cut short or not an STL file; export the mesh anew");
    }
    return read_binary(bytes, file);
}

}  // namespace normalscope
