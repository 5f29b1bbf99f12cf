#include "core/base/beside.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/polygons.h"
#include "core/mesh/words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace normalscope {

namespace {

constexpr std::size_t kTextWorthAThread = std::size_t{1} << 20;

/// One part of the file.
struct Part {
    std::vector<glm::dvec3> positions, normals;
    Polygons::Block faces;
    bool relative = false;  // counts back from the vertices read so far
    std::string mistake{};  // of the statement that cannot be used; empty: there is none
    std::size_t place = 0;  // of the last statement, in the file
};

// OBJ counts from 1, or back from the last if negative; 0 stands for an index that is not given. What lies outside of
// every file becomes an index that is out of range.
std::int32_t index_of(std::int64_t given, std::size_t so_far) {
    const std::int64_t index = given >= 0 ? given - 1 : static_cast<std::int64_t>(so_far) + given;
    return static_cast<std::int32_t>(given < 0 && index < 0 ? Polygons::kNowhere
                                                            : std::min<std::int64_t>(index, Polygons::kNowhere));
}

// A vertex's number, or 1/2/3, of which the second is its texture's and the third its normal's; 0 where there is none.
bool read_corner(Words& words, std::array<std::int64_t, 3>& numbers) {
    auto& [position, texture, normal] = numbers;
    if (words.take('/') || !words.index(position)) return false;
    if (words.take('/') && !words.index(texture)) return false;
    if (words.take('/') && !words.index(normal)) return false;
    return words.word_is_over();
}

void read_face(Words& words, Part& part) {
    std::uint32_t size = 0;
    for (; !words.line_is_over(); ++size) {
        Words corner = words;
        std::array<std::int64_t, 3> numbers{};
        if (!read_corner(words, numbers)) {
            part.mistake =
                in_quotes(corner.next()) + " is not a corner of a face, which is a vertex's number, or 1/2/3";
            return;
        }
        const auto [position, texture, normal] = numbers;
        part.relative = part.relative || position < 0 || normal < 0;
        part.faces.corners.push_back(
            {index_of(position, part.positions.size()), index_of(normal, part.normals.size())});
    }
    part.faces.sizes.push_back(size);
}

// Materials, groups, lines, free-form curves: everything but vertices, normals and faces is left out.
void read_statements(std::string_view text, std::size_t place, Part& part) {
    for (Words words(text, LineSyntax::Obj); !words.at_end() && part.mistake.empty(); words.skip_line()) {
        part.place = place + static_cast<std::size_t>(words.rest().data() - text.data());
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
    }
}

bool is_continued(std::string_view text, std::size_t newline) {
    const std::string_view line = text.substr(0, newline);
    return line.ends_with('\\') || line.ends_with("\\\r");
}

// The place after the last line end at which no statement goes on; 0 where there is none.
std::size_t end_of_statements(std::string_view text) {
    std::size_t newline = text.rfind('\n');
    while (newline != text.npos && newline > 0 && is_continued(text, newline)) newline = text.rfind('\n', newline - 1);
    return newline == text.npos ? 0 : newline + 1;
}

std::size_t line_of_face(std::string_view text, std::size_t face) {
    Words words(without_mark(text), LineSyntax::Obj);
    for (; !words.at_end(); words.skip_line()) {
        const std::size_t place = text.size() - words.rest().size();
        const std::string_view kind = words.next();
        if ((is_word(kind, "f") || is_word(kind, "fo")) && face-- == 0) return Words::line_at(text, place);
    }
    return 0;
}

/// Gives so many characters more; fewer only at the end.
using Reader = std::function<std::size_t(std::span<char>)>;

struct Source {
    std::function<Reader(std::size_t from)> open;
    std::size_t size = 0;  ///< characters
    std::function<std::string()> all;
    std::string name;
};

/// Characters of a source, whole statements.
struct Range {
    std::size_t begin = 0, end = 0;
};

// A piece at a time in the same memory: for the system to clear as much as a large file takes longer than to read it.
Part read_part(const Source& source, const Range& range) {
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    const std::size_t size = range.end - range.begin;
    Part part;
    // What is reserved and not used costs nothing, but to grow again and again is what a tenth of the reading goes to.
    part.positions.reserve(size / 56);
    part.normals.reserve(size / 56);
    part.faces.corners.reserve(size / 14);
    part.faces.sizes.reserve(size / 42);

    const Reader read = source.open(range.begin);
    std::vector<char> buffer(std::min(size, kPiece));
    std::size_t place = range.begin, filled = 0;
    while (place < range.end && part.mistake.empty()) {
        const std::size_t room = std::min(buffer.size() - filled, range.end - place - filled);
        const std::size_t got = read(std::span(buffer).subspan(filled, room));
        if (got < room) throw InputError(source.name, "became shorter while it was read; try again");
        filled += got;
        const std::string_view text(buffer.data(), filled);
        const bool is_last = place + filled == range.end;
        const std::size_t end = is_last ? filled : end_of_statements(text);
        const std::string_view statements = place > 0 ? text.substr(0, end) : without_mark(text.substr(0, end));
        read_statements(statements, place + end - statements.size(), part);
        if (is_last) break;
        place += end;
        filled -= end;
        std::copy_n(buffer.data() + end, filled, buffer.data());
        if (filled == buffer.size()) buffer.resize(2 * filled);
    }
    return part;
}

// The end of some statement near there.
std::size_t boundary(const Source& source, std::size_t near) {
    constexpr std::size_t kContinuation = 2;  // characters that tell whether a line end is one
    const std::size_t from = near - kContinuation;
    const Reader read = source.open(from);
    std::string text;
    for (std::size_t room = 4096;; room *= 2) {
        const std::size_t filled = text.size();
        text.resize(room);
        const std::size_t got = read(std::span(text).subspan(filled));
        text.resize(filled + got);
        if (const std::size_t end = end_of_statements(text); end > kContinuation) return from + end;
        if (text.size() < room) return source.size;
    }
}

// At least one.
std::vector<Range> ranges_of(const Source& source, std::size_t count) {
    std::vector<Range> ranges;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= count; ++i) {
        const std::size_t at = source.size / count * i, end = i == count ? source.size : boundary(source, at);
        if (end > begin || (i == count && ranges.empty())) ranges.push_back({begin, end});
        begin = std::max(begin, end);
    }
    return ranges;
}

std::vector<Part> read_parts(const Source& source, const std::vector<Range>& ranges) {
    std::vector<Part> parts(ranges.size());
    in_parts(ranges.size(), ranges.size(),
             [&](std::size_t i, std::size_t, std::size_t) { parts[i] = read_part(source, ranges[i]); });
    return parts;
}

Polygons polygons_of(const Source& source) {
    std::vector<Part> parts = read_parts(source, ranges_of(source, threads_for(source.size, kTextWorthAThread)));
    // Indices that count back need everything before them: read the file in one go.
    if (std::any_of(parts.begin() + 1, parts.end(), [](const Part& p) { return p.relative; }))
        parts = read_parts(source, ranges_of(source, 1));

    Polygons polygons;
    std::size_t positions = 0, normals = 0;
    for (const Part& part : parts) {
        positions += part.positions.size();
        normals += part.normals.size();
        if (part.mistake.empty()) continue;
        throw InputError(source.name + ": line " + std::to_string(Words::line_at(source.all(), part.place)) + ": " +
                         part.mistake + "; repair or export the mesh anew");
    }
    polygons.positions.reserve(positions);
    polygons.normals.reserve(normals);
    for (Part& part : parts) {
        polygons.faces.push_back(std::move(part.faces));
        polygons.positions.insert(polygons.positions.end(), part.positions.begin(), part.positions.end());
        polygons.normals.insert(polygons.normals.end(), part.normals.begin(), part.normals.end());
    }
    if (polygons.positions.empty())
        throw InputError(source.name +
                         ": has no vertices, so it is not an OBJ file; a mesh's ending must be its format's");
    polygons.line_of_face = [all = source.all](std::size_t face) { return line_of_face(all(), face); };
    return polygons;
}

}  // namespace

Polygons read_obj(std::string_view text, const std::string& file) {
    const auto open = [text](std::size_t from) -> Reader {
        return [left = text.substr(from)](std::span<char> to) mutable {
            const std::size_t size = left.copy(to.data(), to.size());
            left.remove_prefix(size);
            return size;
        };
    };
    return polygons_of({open, text.size(), [text] { return std::string(text); }, file});
}

Polygons read_obj_file(const std::filesystem::path& file, std::size_t largest) {
    const std::string name = file.string();
    FileReader whole(file, largest);
    if (const std::size_t size = whole.size().value_or(0); size > 0) {
        const auto open = [&](std::size_t from) -> Reader {
            auto reader = std::make_shared<FileReader>(file, largest, from);
            return [reader](std::span<char> to) { return reader->read(to); };
        };
        return polygons_of({open, size, [file, largest] { return read_file(file, largest); }, name});
    }
    // What has no size, such as a pipe, may not be opened twice.
    const auto text = std::make_shared<const std::string>(whole.read_all());
    if (text->empty()) throw InputError(name + ": is empty; export the mesh anew");
    Polygons polygons = read_obj(*text, name);
    polygons.line_of_face = [text](std::size_t face) { return line_of_face(*text, face); };
    return polygons;
}

}  // namespace normalscope
