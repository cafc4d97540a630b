// SPDX-License-Identifier: Apache-2.0
#include "expression/execute.h"

namespace jprim {

using SimTK::Real;
using SimTK::Vec3;

namespace {

Real call(Function function, Real x, Real y) {
    return calcFunction(function, x, y);
}

Taylor<Real> call(Function function, const Taylor<Real>& x, const Taylor<Real>& y) {
    const Real f = calcFunction(function, x.value, y.value);
    return chain(f, calcPartials(function, x.value, y.value, f), x, y);
}

Real call(const Curve& curve, Real x, Real z) {
    return curve.calcValue(x, z);
}

Taylor<Real> call(const Curve& curve, const Taylor<Real>& x, const Taylor<Real>& z) {
    return chain(curve.calcValue(x.value, z.value), curve.calcPartials(x.value, z.value), x, z);
}

Real calcNorm(const Vec3& v) {
    return v.norm();
}

Taylor<Real> calcNorm(const Taylor<Vec3>& v) {
    const Taylor<Real> square = dot(v, v);
    return call(Function::Sqrt, square, square);
}

Real getComponent(const Vec3& v, int axis) {
    return v[axis];
}

Taylor<Real> getComponent(const Taylor<Vec3>& v, int axis) {
    return {v.value[axis], v.first[axis], v.second[axis]};
}

Vec3 makeVector(Real x, Real y, Real z) {
    return {x, y, z};
}

Taylor<Vec3> makeVector(const Taylor<Real>& x, const Taylor<Real>& y, const Taylor<Real>& z) {
    return {{x.value, y.value, z.value}, {x.first, y.first, z.first}, {x.second, y.second, z.second}};
}

}  // namespace

template <class Access>
void execute(const Instruction& instruction, const Curves& curves, Registers& registers) {
    using SimTK::cross;
    using SimTK::dot;
    const std::array<int, 4>& arguments = instruction.arguments;
    const int detail = instruction.detail, result = instruction.result;
    const auto s = [&](int i) -> decltype(auto) { return Access::get(registers.scalars[arguments[i]]); };
    const auto v = [&](int i) -> decltype(auto) { return Access::get(registers.vectors[arguments[i]]); };
    const auto setScalar = [&](const auto& x) { Access::set(registers.scalars[result], x); };
    const auto setVector = [&](const auto& x) { Access::set(registers.vectors[result], x); };
    switch (instruction.operation) {
        case Operation::Add: return setScalar(s(0) + s(1));
        case Operation::Subtract: return setScalar(s(0) - s(1));
        case Operation::Negate: return setScalar(-s(0));
        case Operation::Multiply: return setScalar(s(0) * s(1));
        case Operation::Divide: return setScalar(s(0) / s(1));
        case Operation::Call: return setScalar(call(static_cast<Function>(detail), s(0), s(1)));
        case Operation::Curve: return setScalar(call(*curves[size_t(detail)], s(0), s(1)));
        case Operation::Select: return setScalar(s(findBranch(registers.scalars[arguments[0]].value)));
        case Operation::Dot: return setScalar(dot(v(0), v(1)));
        case Operation::Norm: return setScalar(calcNorm(v(0)));
        case Operation::Component: return setScalar(getComponent(v(0), detail));
        case Operation::Vector: return setVector(makeVector(s(0), s(1), s(2)));
        case Operation::AddVectors: return setVector(v(0) + v(1));
        case Operation::SubtractVectors: return setVector(v(0) - v(1));
        case Operation::Scale: return setVector(s(0) * v(1));
        case Operation::Cross: return setVector(cross(v(0), v(1)));
    }
}

template void execute<ValuesOnly>(const Instruction&, const Curves&, Registers&);
template void execute<WithDerivatives>(const Instruction&, const Curves&, Registers&);

}  // namespace jprim
