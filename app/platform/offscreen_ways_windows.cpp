#include "platform/offscreen_ways.h"

namespace normalscope {

std::span<const OffscreenWay> offscreen_ways() { return hidden_window_ways(); }

}  // namespace normalscope
