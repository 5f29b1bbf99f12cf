#include "core/program/program.h"

#include <algorithm>

namespace normalscope::formulas {

int operands(Code code) {
    switch (code) {
        case Code::Constant:
        case Code::Parameter:
        case Code::Variable: return 0;
        case Code::Add:
        case Code::Subtract:
        case Code::Multiply:
        case Code::Divide:
        case Code::Power:
        case Code::Min:
        case Code::Max:
        case Code::Atan2: return 2;
        case Code::Where: return 3;
        default: return 1;
    }
}

std::optional<int> polynomial_degree(const Program& program, int most) {
    std::vector<int> degrees;
    degrees.reserve(program.size());
    for (const Instruction& i : program) {
        const int a = operands(i.code) > 0 ? degrees[i.a] : 0, b = operands(i.code) > 1 ? degrees[i.b] : 0;
        double degree = 0.0;
        switch (i.code) {
            case Code::Variable: degree = 1.0; break;
            case Code::Add:
            case Code::Subtract: degree = std::max(a, b); break;
            case Code::Multiply: degree = a + b; break;
            case Code::Negate: degree = a; break;
            case Code::IntegerPower:
                if (i.varies && i.constant < 0.0) return std::nullopt;
                degree = a * i.constant;
                break;
            case Code::Divide:
                if (program[i.b].varies) return std::nullopt;
                degree = a;
                break;
            default:
                if (i.varies) return std::nullopt;
        }
        if (!(degree <= most)) return std::nullopt;
        degrees.push_back(static_cast<int>(degree));
    }
    const auto& last = program.back();
    if (last.code == Code::Constant && !std::isfinite(last.constant)) return std::nullopt;
    return degrees.back();
}

}  // namespace normalscope::formulas
