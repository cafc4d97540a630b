// SPDX-License-Identifier: Apache-2.0
// A function expression with both time derivatives, beside the same formula and its derivatives written by hand.
// Also values alone, and the gradient.
#include <chrono>
#include <cmath>

#include "base/format.h"
#include "expression/compile_expression.h"
#include "expression/evaluation.h"

namespace {

using jprim::Evaluation;
using jprim::Operand;
using jprim::Taylor;
using SimTK::Real;

// A driven spring and damper with a stop and friction, in the distance Q, its rate U and the time.
const char* const Text =
    "-350*(Q-0.4)-12*U+STEP(TIME,0.1,0,1.3,25)*SIN(2*PI*TIME-30D)-8*TANH(U/0.01)*EXP(-2*Q)"
    "+0.3*Q**3/(1+U**2)-5*ATAN2(U,Q)-20*MAX(0,0.6-Q)+2*COS(3*Q)*U";

// Q and U are the first two inputs.
class Names : public jprim::Vocabulary {
public:
    explicit Names(jprim::ProgramBuilder& builder)
        : m_Q(builder.addScalarInput(jprim::KinematicLevel::Position)),
          m_U(builder.addScalarInput(jprim::KinematicLevel::Velocity)) {}

    std::optional<Operand> call(jprim::ProgramBuilder&, const jprim::Call& call) override {
        if (call.name == "Q") return m_Q;
        if (call.name == "U") return m_U;
        return std::nullopt;
    }
    const jprim::InterpolatingSpline* findSpline(int) override { return nullptr; }
    std::vector<std::string> getNames() const override { return {"Q", "U"}; }

private:
    Operand m_Q, m_U;
};

jprim::Program compile() {
    jprim::ProgramBuilder builder;
    Names names(builder);
    return builder.finish(jprim::compileExpression(Text, builder, names));
}

// The derivatives of an expression's terms, one after the other, each as short as it can be written.
Taylor<Real> calcByHand(Real t, const Taylor<Real>& q, const Taylor<Real>& u) {
    Taylor<Real> sum{-350 * (q.value - 0.4) - 12 * u.value, -350 * q.first - 12 * u.first,
                     -350 * q.second - 12 * u.second};
    {
        const Real ramp = 1 / 1.2, s = std::fmax(0, std::fmin(1, (t - 0.1) * ramp));
        const bool inside = 0 < s && s < 1;
        const Real h = 25 * s * s * (3 - 2 * s), h1 = inside ? 150 * s * (1 - s) * ramp : 0;
        const Real h2 = inside ? 150 * (1 - 2 * s) * ramp * ramp : 0;
        const Real w = 2 * SimTK::Pi, sine = std::sin(w * t - SimTK::Pi / 6);
        const Real cosine = std::cos(w * t - SimTK::Pi / 6);
        sum.value += h * sine;
        sum.first += h1 * sine + h * w * cosine;
        sum.second += h2 * sine + 2 * h1 * w * cosine - h * w * w * sine;
    }
    {
        const Real T = std::tanh(u.value / 0.01), D = 1 - T * T, r = u.first / 0.01;
        const Real T1 = D * r, T2 = D * u.second / 0.01 - 2 * T * D * r * r;
        const Real E = -8 * std::exp(-2 * q.value), E1 = -2 * q.first * E;
        const Real E2 = -2 * q.second * E - 2 * q.first * E1;
        sum.value += T * E;
        sum.first += T1 * E + T * E1;
        sum.second += T2 * E + 2 * T1 * E1 + T * E2;
    }
    {
        const Real a = 0.3 * q.value * q.value * q.value, a1 = 0.9 * q.value * q.value * q.first;
        const Real a2 = 1.8 * q.value * q.first * q.first + 0.9 * q.value * q.value * q.second;
        const Real b = 1 + u.value * u.value, b1 = 2 * u.value * u.first;
        const Real b2 = 2 * u.first * u.first + 2 * u.value * u.second;
        const Real f = a / b, f1 = (a1 - f * b1) / b;
        sum.value += f;
        sum.first += f1;
        sum.second += (a2 - 2 * f1 * b1 - f * b2) / b;
    }
    {
        const Real r = q.value * q.value + u.value * u.value;
        const Real r1 = 2 * (q.value * q.first + u.value * u.first);
        const Real f1 = (u.first * q.value - u.value * q.first) / r;
        sum.value -= 5 * std::atan2(u.value, q.value);
        sum.first -= 5 * f1;
        sum.second -= 5 * ((u.second * q.value - u.value * q.second) / r - f1 * r1 / r);
    }
    if (q.value < 0.6) {
        sum.value -= 20 * (0.6 - q.value);
        sum.first += 20 * q.first;
        sum.second += 20 * q.second;
    }
    {
        const Real c = 2 * std::cos(3 * q.value), c1 = -6 * std::sin(3 * q.value) * q.first;
        const Real c2 = -9 * c * q.first * q.first - 6 * std::sin(3 * q.value) * q.second;
        sum.value += c * u.value;
        sum.first += c1 * u.value + c * u.first;
        sum.second += c2 * u.value + 2 * c1 * u.first + c * u.second;
    }
    return sum;
}

// Uses all that was calculated.
Real add(const Taylor<Real>& x) {
    return x.value + x.first + x.second;
}

// Nanoseconds per call, the least of some rounds because other processes disturb. The argument changes, and the
// sum of the results is used, so that nothing can be left out.
template <class Action>
double measure(Action action) {
    constexpr int rounds = 15, calls = 20000;
    double least = 1e9;
    volatile Real sum = 0;
    for (int round = 0; round < rounds; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < calls; ++i) sum = sum + action(1e-4 * i);
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
        least = std::min(least, time.count() / calls);
    }
    return least;
}

}  // namespace

int main() {
    Evaluation evaluation(compile());
    const auto supply = [&](Real t) {
        const Taylor<Real> q{0.5 + 0.1 * t, 0.1, 0.3}, u{0.003 * (1 - t), 0.3, -0.2};
        evaluation.setScalarInput(0, q);
        evaluation.setScalarInput(1, u);
        evaluation.setScalarInput(evaluation.getProgram().getTimeInput(), {t, 1, 0});
        return std::pair(q, u);
    };
    Real worst = 0;
    for (const Real t : {0.05, 0.4, 1.1, 1.9}) {
        const auto [q, u] = supply(t);
        const Taylor<Real> ours = evaluation.calcTaylor(), byHand = calcByHand(t, q, u);
        worst =
            std::max({worst, std::abs(ours.value / byHand.value - 1), std::abs(ours.first / byHand.first - 1),
                      std::abs(ours.second / byHand.second - 1)});
    }
    const double byHand = measure([&](Real t) {
        const auto [q, u] = supply(t);
        return add(calcByHand(t, q, u));
    });
    const double ours = measure([&](Real t) { return supply(t), add(evaluation.calcTaylor()); });
    const double value = measure([&](Real t) { return supply(t), evaluation.calcValue(); });
    const double gradient = measure([&](Real t) {
        supply(t);
        evaluation.calcValue();
        evaluation.calcGradient();
        return evaluation.getScalarGradient(0);
    });
    fmt::print("{}\n{} operations; largest relative difference {:.1e}\n", Text,
               evaluation.getProgram().getNumOperations(), worst);
    fmt::print(
        "with both derivatives {:8.0f} ns\nwritten by hand       {:8.0f} ns\nratio                 {:8.1f}\n",
        ours, byHand, ours / byHand);
    fmt::print("values alone          {:8.0f} ns\nvalue and gradient    {:8.0f} ns\n", value, gradient);
    return worst < 1e-9 ? 0 : 1;
}
