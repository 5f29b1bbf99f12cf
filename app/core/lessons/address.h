#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace normalscope {

// What a browser's address says after "#": a scene's name, a lesson's and its step as NAME/3, exercises:42, or a link.

/// The name that open_name() knows, of "#shear" or of a whole address with that at its end; none for what is no address.
/// Throws InputError for an address that names nothing.
std::optional<std::string> name_of_address(std::string_view text);

/// A lesson's step, counted from 0.
std::string address_of_step(const std::string& lesson, std::size_t step);

/// HTML for another page, which shows this in a frame. `address`: the program's page with a name or link behind "#", or that
/// alone, for a page that lies beside normalscope.html. `title`: for whoever does not see it.
std::string frame_html(std::string_view address, std::string_view title);

}  // namespace normalscope
