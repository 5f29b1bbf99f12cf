#include "core/base/error.h"
#include "core/mesh/polygons.h"

#include <bit>
#include <cstring>
#include <limits>

namespace normalscope {

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;  // bytes of a binary file: 80 of comment and the count; each facet

// The number of facets that a binary file of this beginning has.
std::uint64_t claimed_facets(std::string_view bytes) {
    std::uint64_t count = 0;
    for (std::size_t k = kHeader; k-- > kHeader - 4;) count = count << 8 | static_cast<unsigned char>(bytes[k]);
    return count;
}

// A binary file's comment may begin with "solid" too, so its length decides before its first word.
void check_size(std::string_view bytes, const std::string& file) {
    if (bytes.size() >= kHeader && kHeader + kFacet * claimed_facets(bytes) == bytes.size()) return;
    const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const bool text = bytes.substr(start).starts_with("solid") && bytes.find('\0') == bytes.npos;
    if (!text && bytes.size() >= kHeader)
        throw InputError(file + ": announces " + std::to_string(claimed_facets(bytes)) +
                         " facets, which is not what its " + std::to_string(bytes.size()) +
                         " bytes hold, so it is cut short or no STL file; export the mesh anew");
    if (!text)
        throw InputError(file +
                         ": is too short for an STL file and does not begin with \"solid\"; export the mesh anew");
    if (bytes.find("endsolid") == bytes.npos)
        throw InputError(file + ": ends before its \"endsolid\"; export the mesh anew");
}

// STL names no vertices: every facet brings its three corners. Those at exactly the same place become one, so that
// neighbours are known and normals can be smooth.
void weld(Polygons& polygons) {
    constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
    const std::vector<glm::dvec3>& given = polygons.positions;
    const std::size_t slots = std::bit_ceil(2 * given.size() + 1);
    std::vector<std::uint32_t> table(slots, kFree);  // open addressing
    std::vector<glm::dvec3> places;
    std::vector<std::int32_t> place_of(given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const glm::dvec3 p = given[i] + 0.0;  // −0 becomes 0, which equals it but has other bits
        std::uint64_t bits[3], hash = 0;
        std::memcpy(bits, &p, sizeof bits);
        for (const std::uint64_t b : bits) {  // splitmix64's mixing steps
            hash = (hash ^ b) * 0xBF58476D1CE4E5B9u;
            hash ^= hash >> 31;
        }
        std::size_t slot = hash & (slots - 1);
        while (table[slot] != kFree && places[table[slot]] != p) slot = (slot + 1) & (slots - 1);
        if (table[slot] == kFree) {
            table[slot] = static_cast<std::uint32_t>(places.size());
            places.push_back(p);
        }
        place_of[i] = static_cast<std::int32_t>(table[slot]);
    }
    for (Polygons::Block& block : polygons.faces)
        for (Polygons::Corner& c : block.corners)
            // Facets' normals only repeat what the corners say, and are often wrong or zero.
            c = {c.position < 0 ? c.position : place_of[static_cast<std::size_t>(c.position)], Polygons::kNone};
    polygons.positions = std::move(places);
    polygons.normals.clear();
    polygons.lacking = "vertex normals";
}

}  // namespace

Polygons read_stl(std::string_view bytes, const std::string& file) {
    check_size(bytes, file);
    Polygons polygons = import_by_assimp(bytes, "stl", file);
    weld(polygons);
    return polygons;
}

}  // namespace normalscope
