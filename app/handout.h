#pragma once

#include "cli/options.h"

#include <string>

namespace normalscope {

/// A lesson as an HTML page that needs nothing beside it: a picture, its caption and its equations a step, and the
/// answers to the questions at the end. Throws InputError and ContextError.
std::string handout(const HandoutCommand& command);

}  // namespace normalscope
