#include "core/base/error.h"
#include "core/base/threads.h"
#include "core/mesh/polygons.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <future>
#include <limits>
#include <system_error>

namespace normalscope {

namespace {

constexpr std::size_t kTextWorthAThread = std::size_t{1} << 20;

/// One part of the file.
struct Part {
    std::vector<glm::dvec3> positions, normals;
    Polygons::Block faces;
    bool relative = false;             // counts back from the vertices read so far
    const char* bad_vertex = nullptr;  // the line that is not three numbers
};

// OBJ counts from 1, or back from the last if negative; 0 stands for an index that is not given. What lies outside of
// every file becomes an index that is out of range.
std::int32_t index_of(std::int64_t given, std::size_t so_far) {
    constexpr std::int64_t kNowhere = std::numeric_limits<std::int32_t>::max();
    const std::int64_t index = given >= 0 ? given - 1 : static_cast<std::int64_t>(so_far) + given;
    return static_cast<std::int32_t>(given < 0 && index < 0 ? kNowhere : std::min(index, kNowhere));
}

/// Goes through a text, line by line and word by word. By hand: of a large mesh's capture, a library's reading takes a
/// quarter.
class Words {
public:
    explicit Words(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    bool at_end() const { return at_ == end_; }
    const char* place() const { return at_; }
    void skip_line() {
        while (at_ < end_ && !ends_line(*at_)) ++at_;
        if (at_ < end_) ++at_;
    }
    /// The rest of the line's next word, empty where there is none.
    std::string_view next() {
        while (at_ < end_ && is_blank(*at_)) ++at_;
        const char* const begin = at_;
        while (at_ < end_ && !is_blank(*at_) && !ends_line(*at_) && *at_ != '#') ++at_;
        return {begin, at_};
    }
    /// Three numbers; false where there are fewer, or what is none.
    bool numbers(glm::dvec3& to) {
        for (int i = 0; i < 3; ++i)
            if (!plain_number(to[i]) && !any_number(to[i])) return false;
        return true;
    }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t'; }
    static bool ends_line(char c) { return c == '\n' || c == '\r'; }
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }

    /// Such as -12.345, with so few digits that both the whole number and the power of ten are exact: then so is their
    /// quotient, but for one rounding (Clinger, "How to read floating point numbers accurately", 1990).
    bool plain_number(double& to) {
        static constexpr std::array kPowers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
        const char* at = at_;
        while (at < end_ && is_blank(*at)) ++at;
        const bool negative = at < end_ && *at == '-';
        at += negative ? 1 : 0;
        std::int64_t whole = 0;
        std::ptrdiff_t digits = 0, decimals = 0;
        for (; at < end_ && is_digit(*at) && digits < 15; ++at, ++digits) whole = 10 * whole + (*at - '0');
        if (at < end_ && *at == '.')
            for (++at; at < end_ && is_digit(*at) && digits < 15; ++at, ++digits, ++decimals)
                whole = 10 * whole + (*at - '0');
        if (digits == 0 || (at < end_ && !is_blank(*at) && !ends_line(*at))) return false;
        const double size = static_cast<double>(whole) / kPowers[static_cast<std::size_t>(decimals)];
        to = negative ? -size : size;
        at_ = at;
        return true;
    }
    bool any_number(double& to) {
        std::string_view word = next();
        if (word.starts_with('+')) word.remove_prefix(1);
        // from_chars knows NaN and infinities, which no vertex may have.
        if (word.empty() || (!is_digit(word.back()) && word.back() != '.')) return false;
        const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), to);
        if (error == std::errc::result_out_of_range) to = std::strtod(std::string(word).c_str(), nullptr);
        return rest == word.data() + word.size();
    }

    const char *at_, *end_;
};

// One of a corner's indices, up to a slash, and 0 where there is none.
std::int64_t taken_index(std::string_view& corner) {
    constexpr std::int64_t kBeyondAll = std::int64_t{1} << 40;
    const char *at = corner.data(), *const end = at + corner.size();
    const bool negative = at < end && *at == '-';
    at += negative ? 1 : 0;
    std::int64_t index = 0;
    for (; at < end && *at >= '0' && *at <= '9'; ++at) index = std::min(10 * index + (*at - '0'), kBeyondAll);
    if (at < end && *at == '/') ++at;
    corner.remove_prefix(static_cast<std::size_t>(at - corner.data()));
    return negative ? -index : index;
}

void read_face(Words& words, Part& part) {
    std::uint32_t size = 0;
    for (std::string_view corner = words.next(); !corner.empty(); corner = words.next(), ++size) {
        const std::int64_t position = taken_index(corner);
        taken_index(corner);  // of texture coordinates
        const std::int64_t normal = taken_index(corner);
        part.relative = part.relative || position < 0 || normal < 0;
        part.faces.corners.push_back(
            {index_of(position, part.positions.size()), index_of(normal, part.normals.size())});
    }
    part.faces.sizes.push_back(size);
}

// Materials, groups, lines, free-form curves: everything but vertices, normals and faces is left out.
Part read_part(std::string_view text) {
    Part part;
    for (Words words(text); !words.at_end(); words.skip_line()) {
        const char* const line = words.place();
        const std::string_view kind = words.next();
        glm::dvec3 numbers(0.0);
        if (kind == "v") {
            if (!words.numbers(numbers)) {
                part.bad_vertex = line;
                return part;
            }
            part.positions.push_back(numbers);
        } else if (kind == "vn") {
            // A vertex that moved to 0 would be hard to find; a normal of 0 is one that has to be computed, and said so.
            part.normals.push_back(words.numbers(numbers) ? numbers : glm::dvec3(0.0));
        } else if (kind == "f") {
            read_face(words, part);
        }
    }
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
    std::vector<Part> parts = read_parts(cut(text, threads_for(text.size(), kTextWorthAThread)));
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
    std::size_t positions = 0, normals = 0;
    for (const Part& part : parts) positions += part.positions.size(), normals += part.normals.size();
    polygons.positions.reserve(positions);
    polygons.normals.reserve(normals);
    for (Part& part : parts) {
        polygons.faces.push_back(std::move(part.faces));
        polygons.positions.insert(polygons.positions.end(), part.positions.begin(), part.positions.end());
        polygons.normals.insert(polygons.normals.end(), part.normals.begin(), part.normals.end());
    }
    if (polygons.positions.empty())
        throw InputError(file + ": has no vertices, so it is no OBJ file; a mesh's ending must be its format's");
    return polygons;
}

}  // namespace normalscope
