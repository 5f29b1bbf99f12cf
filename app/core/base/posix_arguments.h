#pragma once

namespace normalscope {

/// What begin_process was given, with a null behind the last one, to start the program anew. Null before.
char** own_arguments();

}  // namespace normalscope
