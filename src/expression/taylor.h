// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_TAYLOR_H_
#define JPRIM_SRC_EXPRESSION_TAYLOR_H_

#include "SimTKcommon.h"

namespace jprim {

/// A quantity (a Real or a Vec3) with its first and second time derivatives. The operators below are those of
/// Real and Vec3, so that one formula serves for values alone and for values with derivatives.
template <class T>
struct Taylor {
    T value = T(0);
    T first = T(0);
    T second = T(0);
};

template <class T>
Taylor<T> operator+(const Taylor<T>& a, const Taylor<T>& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
}

template <class T>
Taylor<T> operator-(const Taylor<T>& a, const Taylor<T>& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
}

template <class T>
Taylor<T> operator-(const Taylor<T>& a) {
    return {-a.value, -a.first, -a.second};
}

/// Any product, which may be of two types: (a b)'' = a'' b + 2 a' b' + a b''.
template <class A, class B, class Product>
auto multiply(const Taylor<A>& a, const Taylor<B>& b, Product times) -> Taylor<decltype(times(A(), B()))> {
    return {times(a.value, b.value), times(a.first, b.value) + times(a.value, b.first),
            times(a.second, b.value) + 2 * times(a.first, b.first) + times(a.value, b.second)};
}

template <class T>
Taylor<T> operator*(const Taylor<SimTK::Real>& a, const Taylor<T>& b) {
    return multiply(a, b, [](SimTK::Real x, const T& y) -> T { return x * y; });
}

inline Taylor<SimTK::Real> dot(const Taylor<SimTK::Vec3>& a, const Taylor<SimTK::Vec3>& b) {
    using SimTK::Vec3;
    return multiply(a, b, [](const Vec3& x, const Vec3& y) { return SimTK::dot(x, y); });
}

inline Taylor<SimTK::Vec3> cross(const Taylor<SimTK::Vec3>& a, const Taylor<SimTK::Vec3>& b) {
    using SimTK::Vec3;
    return multiply(a, b, [](const Vec3& x, const Vec3& y) -> Vec3 { return SimTK::cross(x, y); });
}

/// From a = q b: a' = q' b + q b', a'' = q'' b + 2 q' b' + q b''.
inline Taylor<SimTK::Real> operator/(const Taylor<SimTK::Real>& a, const Taylor<SimTK::Real>& b) {
    const SimTK::Real value = a.value / b.value;
    const SimTK::Real first = (a.first - value * b.first) / b.value;
    return {value, first, (a.second - 2 * first * b.first - value * b.second) / b.value};
}

}  // namespace jprim

#endif
