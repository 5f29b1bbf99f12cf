#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace normalscope {

/// Bytes as text (RFC 4648), as a page's data: addresses hold pictures.
std::string base64(std::string_view bytes);

/// The same in letters that addresses, mail and chat leave alone, and without padding.
std::string base64url(std::string_view bytes);
/// Its bytes, white space passed over; empty where there is any other character.
std::optional<std::string> from_base64url(std::string_view text);

}  // namespace normalscope
