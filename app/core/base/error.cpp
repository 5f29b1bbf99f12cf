#include "core/base/error.h"

#include "core/base/utf8.h"

namespace normalscope {

Error::Error(const std::string& subject, const std::string& reason_alone)
    : std::runtime_error(in_one_line(subject.empty() ? reason_alone : subject + ": " + reason_alone)),
      reason(reason_alone) {}

}  // namespace normalscope
