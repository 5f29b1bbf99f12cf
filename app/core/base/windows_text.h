#pragma once

#include <string>
#include <string_view>

namespace normalscope {

/// Windows has its text in UTF-16. What is no text in the one or the other becomes U+FFFD.
std::wstring wide(std::string_view utf8);
std::string narrow(std::wstring_view utf16);

}  // namespace normalscope
