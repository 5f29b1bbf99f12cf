#pragma once

#include "core/scene/scene.h"

#include <string>
#include <string_view>

namespace normalscope {

/// A whole scene as one line of text, to be sent and pasted: "normalscope:1.", and in letters that mail and chat leave
/// alone (base64url, RFC 4648) four bytes of CRC-32 and the scene's JSON, compressed by zlib. A mesh goes by its path.
std::string link_of(const Scene& scene);

/// Whether the text, but for white space around it, begins as a link does.
bool is_link(std::string_view text);

/// Throws InputError for what is damaged, cut off or made by a newer version.
Scene scene_of_link(std::string_view link);

}  // namespace normalscope
