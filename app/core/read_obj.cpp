#include "core/error.h"
#include "core/polygons.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <future>
#include <istream>
#include <limits>
#include <streambuf>
#include <thread>

namespace normalscope {

namespace {

constexpr std::size_t kTextWorthAThread = std::size_t{1} << 20;

// A part of the text as a stream, without the copy that a stringstream would make.
class TextBuffer : public std::streambuf {
public:
    explicit TextBuffer(std::string_view text) {
        char* begin = const_cast<char*>(text.data());  // streambuf's interface; nothing is written
        setg(begin, begin, begin + text.size());
    }
};

/// One part of the file, as tinyobjloader's callbacks deliver it.
struct Part {
    std::vector<glm::dvec3> positions, normals;
    Polygons::Block faces;
    bool relative = false;             // counts back from the vertices read so far
    const char* bad_vertex = nullptr;  // the line that is not three numbers
    bool understood = true;            // by tinyobjloader
};

// OBJ counts from 1, or back from the last if negative; 0 stands for an index that is not given. What lies outside of
// every file becomes an index that is out of range.
std::int32_t index_of(int given, std::size_t so_far) {
    constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::max();
    if (given >= 0) return given - 1;
    const std::int64_t index = static_cast<std::int64_t>(so_far) + given;
    return index < 0 ? kNowhere : static_cast<std::int32_t>(index);
}

// tinyobjloader takes what is no number for 0 without a word, and a vertex that moved to 0 is hard to find.
const char* first_bad_vertex(std::string_view text) {
    static constexpr std::array<bool, 256> kInNumber = [] {
        std::array<bool, 256> in{};
        for (const char c : std::string_view("0123456789+-.eE")) in[static_cast<unsigned char>(c)] = true;
        return in;
    }();
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
    const char *at = text.data(), *const end = at + text.size();
    while (at < end) {
        const char* const line = at;
        while (at < end && is_blank(*at)) ++at;
        if (end - at > 2 && at[0] == 'v' && is_blank(at[1])) {
            int numbers = 0;
            for (++at; at < end && !ends_line(*at) && *at != '#';) {
                while (at < end && is_blank(*at)) ++at;
                const char* const word = at;
                while (at < end && kInNumber[static_cast<unsigned char>(*at)]) ++at;
                numbers += at > word ? 1 : 0;
                if (at < end && !is_blank(*at) && !ends_line(*at) && *at != '#') return line;
            }
            if (numbers < 3) return line;
        }
        at = std::find_if(at, end, ends_line);
        if (at < end) ++at;
    }
    return nullptr;
}

Part read_part(std::string_view text) {
    Part part;
    part.bad_vertex = first_bad_vertex(text);
    if (part.bad_vertex) return part;
    TextBuffer buffer(text);
    std::istream stream(&buffer);
    using Real = tinyobj::real_t;
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* to, Real x, Real y, Real z, Real) {
        static_cast<Part*>(to)->positions.emplace_back(x, y, z);
    };
    callback.normal_cb = [](void* to, Real x, Real y, Real z) {
        static_cast<Part*>(to)->normals.emplace_back(x, y, z);
    };
    callback.index_cb = [](void* to, tinyobj::index_t* indices, int count) {
        Part& p = *static_cast<Part*>(to);
        for (int i = 0; i < count; ++i) {
            p.relative = p.relative || indices[i].vertex_index < 0 || indices[i].normal_index < 0;
            p.faces.corners.push_back({index_of(indices[i].vertex_index, p.positions.size()),
                                       index_of(indices[i].normal_index, p.normals.size())});
        }
        p.faces.sizes.push_back(static_cast<std::uint32_t>(count));
    };
    // The callbacks, and not the usual LoadObj: that one drops polygons' identity and holds 255 corners at most.
    // Materials are not read, so that a missing .mtl file is no problem.
    part.understood = tinyobj::LoadObjWithCallback(stream, callback, &part);
    return part;
}

// Cut at line ends into so many parts of about the same length.
std::vector<std::string_view> cut(std::string_view text, std::size_t count) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= count; ++i) {
        const std::size_t newline = i == count ? text.npos : text.find('\n', std::max(begin, text.size() / count * i));
        const std::size_t end = newline == text.npos ? text.size() : newline + 1;
        if (end > begin) parts.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return parts;
}

std::vector<Part> read_parts(const std::vector<std::string_view>& texts) {
    std::vector<std::future<Part>> others;
    for (std::size_t i = 1; i < texts.size(); ++i)
        others.push_back(std::async(std::launch::async, read_part, texts[i]));
    std::vector<Part> parts;
    if (!texts.empty()) parts.push_back(read_part(texts[0]));
    for (std::future<Part>& part : others) parts.push_back(part.get());
    return parts;
}

}  // namespace

Polygons read_obj(std::string_view text, const std::string& file) {
    const std::size_t threads = std::clamp<std::size_t>(text.size() / kTextWorthAThread, 1,
                                                        std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
    std::vector<Part> parts = read_parts(cut(text, threads));
    // Indices that count back need everything before them: read the file in one go.
    if (std::any_of(parts.begin() + (parts.empty() ? 0 : 1), parts.end(), [](const Part& p) { return p.relative; }))
        parts = read_parts({text});

    Polygons polygons;
    for (const Part& part : parts) {
        if (!part.bad_vertex) continue;
        const std::size_t at = static_cast<std::size_t>(part.bad_vertex - text.data());
        const std::size_t line = 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, at), '\n'));
        throw InputError(file + ": line " + std::to_string(line) +
                         ": a vertex needs three numbers; repair or export the mesh anew");
    }
    for (Part& part : parts) {
        polygons.faces.push_back(std::move(part.faces));
        if (&part == parts.data()) {
            polygons.positions = std::move(part.positions);
            polygons.normals = std::move(part.normals);
            continue;
        }
        polygons.positions.insert(polygons.positions.end(), part.positions.begin(), part.positions.end());
        polygons.normals.insert(polygons.normals.end(), part.normals.begin(), part.normals.end());
    }
    if (std::ranges::any_of(parts, [](const Part& p) { return !p.understood; }))
        throw InputError(file + ": has lines that are no OBJ; repair or export the mesh anew");
    if (polygons.positions.empty())
        throw InputError(file + ": has no vertices, so it is no OBJ file; a mesh's ending must be its format's");
    return polygons;
}

}  // namespace normalscope
