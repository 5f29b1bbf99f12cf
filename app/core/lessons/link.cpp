#include "core/lessons/link.h"

#include "core/base/base64.h"
#include "core/base/error.h"
#include "core/scene/scene_json.h"

#include <zlib.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <optional>

namespace normalscope {

namespace {

constexpr std::string_view kScheme = "normalscope:";
// A scene of 200 matrices is far below; more would be a bomb.
constexpr std::size_t kLargestScene = std::size_t{1} << 20;

[[noreturn]] void fail(const std::string& what) { throw InputError("link", what); }

std::string crc_of(std::string_view bytes) {
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(crc >> shift & 255);
    return text;
}

std::string_view trimmed(std::string_view text) {
    const auto space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!text.empty() && space(text.front())) text.remove_prefix(1);
    while (!text.empty() && space(text.back())) text.remove_suffix(1);
    return text;
}

}  // namespace

std::string link_of(const Scene& scene) {
    const std::string json = scene_json(scene).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    uLongf size = compressBound(static_cast<uLong>(json.size()));
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(json.data()),
                  static_cast<uLong>(json.size()), Z_BEST_COMPRESSION) != Z_OK)
        fail("the scene cannot be compressed");
    packed.resize(size);
    return std::string(kScheme) + "1." + base64url(crc_of(packed) + packed);
}

bool is_link(std::string_view text) { return trimmed(text).starts_with(kScheme); }

Scene scene_of_link(std::string_view link) {
    link = trimmed(link);
    link.remove_prefix(std::min(kScheme.size(), link.size()));
    const auto dot = link.find('.');
    const std::string_view version = link.substr(0, std::min(dot, link.size()));
    if (dot == std::string_view::npos || version.empty() || version.size() > 6 ||
        version.find_first_not_of("0123456789") != std::string_view::npos)
        fail("it is cut off or damaged: it does not begin with normalscope:1.; copy it again");
    if (version != "1")
        fail("it was made by a newer version of normalscope (its format is " + std::string(version) +
             "; this program reads format 1)");
    const std::optional<std::string> decoded = from_base64url(link.substr(dot + 1));  // mail breaks long lines
    if (!decoded) fail("it has a character that links do not have; it was changed on its way, so copy it again");
    const std::string& bytes = *decoded;
    if (bytes.size() < 5 || crc_of(std::string_view(bytes).substr(4)) != bytes.substr(0, 4))
        fail("it is cut off or damaged (its checksum is wrong); copy it again");
    std::string json(kLargestScene, '\0');
    uLongf size = static_cast<uLongf>(json.size());
    if (uncompress(reinterpret_cast<Bytef*>(json.data()), &size, reinterpret_cast<const Bytef*>(bytes.data() + 4),
                   static_cast<uLong>(bytes.size() - 4)) != Z_OK)
        fail("what it holds cannot be unpacked; copy it again");
    json.resize(size);
    return parse_scene(json, "link");
}

}  // namespace normalscope
