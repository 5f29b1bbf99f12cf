#include "core/base/beside.h"
#include "core/base/error.h"
#include "core/mesh/polygons.h"
#include "core/mesh/words.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace normalscope {

namespace {

constexpr std::size_t kTextWorthAThread = std::size_t{1} << 20;

/// One part of the file.
struct Part {
    std::vector<glm::dvec3> positions, normals;
    Polygons::Block faces;
    bool relative = false;  // counts back from the vertices read so far
    std::string mistake{};  // of the statement that cannot be used; empty: there is none
    std::size_t left = 0;   // where it is: characters up to the part's end
};

// OBJ counts from 1, or back from the last if negative; 0 stands for an index that is not given. What lies outside of
// every file becomes an index that is out of range.
std::int32_t index_of(std::int64_t given, std::size_t so_far) {
    const std::int64_t index = given >= 0 ? given - 1 : static_cast<std::int64_t>(so_far) + given;
    return static_cast<std::int32_t>(given < 0 && index < 0 ? Polygons::kNowhere
                                                            : std::min<std::int64_t>(index, Polygons::kNowhere));
}

// Takes one of a corner's numbers, up to a slash: 0 where there is none, and nothing where there is something else.
std::optional<std::int64_t> taken_index(std::string_view& corner) {
    constexpr std::int64_t kBeyondAll = std::int64_t{1} << 40;
    const char *at = corner.data(), *const end = at + corner.size();
    const bool negative = at < end && *at == '-';
    at += negative ? 1 : 0;
    const char* const digits = at;
    std::int64_t index = 0;
    for (; at < end && *at >= '0' && *at <= '9'; ++at) index = std::min(10 * index + (*at - '0'), kBeyondAll);
    if ((negative && at == digits) || (at < end && *at != '/')) return std::nullopt;
    if (at < end) ++at;
    corner.remove_prefix(static_cast<std::size_t>(at - corner.data()));
    return negative ? -index : index;
}

void read_face(Words& words, Part& part) {
    std::uint32_t size = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++size) {
        std::string_view rest = word;
        const auto position = taken_index(rest), texture = taken_index(rest), normal = taken_index(rest);
        if (!position || !texture || !normal || !rest.empty() || word.starts_with('/')) {
            part.mistake = quoted(word) + " is no corner of a face, which is a vertex's number, or 1/2/3";
            return;
        }
        part.relative = part.relative || *position < 0 || *normal < 0;
        part.faces.corners.push_back(
            {index_of(*position, part.positions.size()), index_of(*normal, part.normals.size())});
    }
    part.faces.sizes.push_back(size);
}

// Materials, groups, lines, free-form curves: everything but vertices, normals and faces is left out.
Part read_part(std::string_view text) {
    Part part;
    // Of a large file with normals there is as much as this, mostly: what is reserved and not used costs nothing, but to
    // grow again and again is what a tenth of the reading goes to.
    part.positions.reserve(text.size() / 56);
    part.normals.reserve(text.size() / 56);
    part.faces.corners.reserve(text.size() / 14);
    part.faces.sizes.reserve(text.size() / 42);
    for (Words words(text, LineSyntax::Obj); !words.at_end(); words.skip_line()) {
        const std::size_t left = words.rest().size();
        const std::string_view kind = words.next();
        glm::dvec3 numbers(0.0);
        if (is_word(kind, "v")) {
            if (!words.numbers(numbers)) part.mistake = "a vertex needs three numbers";
            part.positions.push_back(numbers);
        } else if (is_word(kind, "vn")) {
            // A vertex that moved to 0 would be hard to find; a normal of 0 is one that has to be computed, and said so.
            part.normals.push_back(words.numbers(numbers) ? numbers : glm::dvec3(0.0));
        } else if (is_word(kind, "f") || is_word(kind, "fo")) {
            read_face(words, part);
        }
        if (!part.mistake.empty()) {
            part.left = left;
            return part;
        }
    }
    return part;
}

bool is_continued(std::string_view text, std::size_t newline) {
    const std::string_view line = text.substr(0, newline);
    return line.ends_with('\\') || line.ends_with("\\\r");
}

// Cut at line ends into so many parts of about the same length.
std::vector<std::string_view> cut(std::string_view text, std::size_t count) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= count; ++i) {
        std::size_t newline = i == count ? text.npos : text.find('\n', std::max(begin, text.size() / count * i));
        while (newline != text.npos && is_continued(text, newline)) newline = text.find('\n', newline + 1);
        const std::size_t end = newline == text.npos ? text.size() : newline + 1;
        if (end > begin) parts.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return parts;
}

std::size_t line_of_face(std::string_view text, std::size_t face) {
    Words words(text, LineSyntax::Obj);
    for (; !words.at_end(); words.skip_line()) {
        const std::size_t place = text.size() - words.rest().size();
        const std::string_view kind = words.next();
        if ((is_word(kind, "f") || is_word(kind, "fo")) && face-- == 0) return Words::line_at(text, place);
    }
    return 0;
}

std::vector<Part> read_parts(const std::vector<std::string_view>& texts) {
    std::vector<Beside<Part>> others;
    for (std::size_t i = 1; i < texts.size(); ++i)
        others.push_back(beside([text = texts[i]] { return read_part(text); }));
    std::vector<Part> parts;
    if (!texts.empty()) parts.push_back(read_part(texts[0]));
    for (Beside<Part>& part : others) parts.push_back(part.get());
    return parts;
}

}  // namespace

Polygons read_obj(std::string_view text, const std::string& file) {
    text = without_mark(text);
    std::vector<std::string_view> texts = cut(text, threads_for(text.size(), kTextWorthAThread));
    std::vector<Part> parts = read_parts(texts);
    // Indices that count back need everything before them: read the file in one go.
    if (std::any_of(parts.begin() + (parts.empty() ? 0 : 1), parts.end(), [](const Part& p) { return p.relative; }))
        parts = read_parts(texts = {text});

    Polygons polygons;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].mistake.empty()) continue;
        const char* const place = texts[i].data() + texts[i].size() - parts[i].left;
        const std::size_t line = Words::line_at(text, static_cast<std::size_t>(place - text.data()));
        throw InputError(file + ": line " + std::to_string(line) + ": " + parts[i].mistake +
                         "; repair or export the mesh anew");
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
    polygons.line_of_face = [text](std::size_t face) { return line_of_face(text, face); };
    return polygons;
}

}  // namespace normalscope
