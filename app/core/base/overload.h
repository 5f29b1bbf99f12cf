#pragma once

namespace normalscope {

/// One callable from several, for std::visit: Overload{[](A) {…}, [](B) {…}}.
template <class... F>
struct Overload : F... {
    using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

}  // namespace normalscope
