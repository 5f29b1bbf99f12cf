#pragma once

#include <string>
#include <string_view>

namespace normalscope {

/// What anybody may have written, for HTML's text and attributes.
std::string html_text(std::string_view utf8);
/// The same with the symbols of the derivation set as such: n_obj and the like in italics, with a subscript, in their
/// colours' classes.
std::string html_math(std::string_view utf8);
/// The same for XML, which has no way at all to write control characters, U+FFFE and U+FFFF.
std::string xml_text(std::string_view utf8);

}  // namespace normalscope
