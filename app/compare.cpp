#include "compare.h"

#include "core/image_difference.h"
#include "core/png.h"

#include <algorithm>
#include <cstdio>

namespace normalscope {

int compare(const CompareCommand& command) {
    const Image actual = read_png(command.actual), expected = read_png(command.expected);
    if (command.diff) write_png(*command.diff, difference_picture(actual, expected, command.tolerance));
    std::FILE* const out = command.diff == "/dev/stdout" ? stderr : stdout;  // not into the picture

    if (actual.size != expected.size) {
        std::fprintf(out, "differ: the size is %dx%d, expected %dx%d\n", actual.size.x, actual.size.y, expected.size.x,
                     expected.size.y);
        return 1;
    }
    const ImageDifference d = image_difference(actual, expected, command.tolerance);
    const bool agree = d.share_beyond <= command.share;
    if (d.worst_by == 0) {
        std::fprintf(out, "agree: %dx%d, every pixel is the same\n", actual.size.x, actual.size.y);
        return 0;
    }
    // A share in full: rounded, it could read as the very limit that it is beyond.
    std::fprintf(out,
                 "%s: %lld of %dx%d pixels (a share of %.9g, %.9g allowed) are off by more than %d of 255; "
                 "most %d at %d,%d; most by channel %d %d %d %d, mean %.4f %.4f %.4f %.4f\n",
                 agree ? "agree" : "differ", static_cast<long long>(d.pixels_beyond), actual.size.x, actual.size.y,
                 d.share_beyond, command.share, command.tolerance, d.worst_by, d.worst.x, d.worst.y, d.most[0],
                 d.most[1], d.most[2], d.most[3], d.mean[0], d.mean[1], d.mean[2], d.mean[3]);
    return agree ? 0 : 1;
}

}  // namespace normalscope
