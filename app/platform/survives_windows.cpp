#include "platform/driver_variables.h"

namespace normalscope {

// No process can be divided in two there: the attempt itself has to tell.
bool survives(const std::function<void()>&) { return true; }

}  // namespace normalscope
