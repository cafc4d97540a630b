// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_REPORT_ANIMATION_H_
#define JPRIM_REPORT_ANIMATION_H_

#include <functional>
#include <memory>
#include <string>

#include "SimTKsimbody.h"
#include "jprim/simbody_abi.h"

namespace jprim {

/// Records how a Simbody system looks over time, and writes that as one HTML file that opens in a browser: what a
/// Visualizer shows, to be kept. For programs without a dataset; writeReport() does more for those with one.
///
///     Animation animation(system, "pendulum");
///     animation.addCurve("angle", "rad", [&](const State& s) { return pin.getAngle(s); });
///     … at each output time: animation.record(state);
///     animation.write("pendulum.html");
///
/// Bodies are drawn by the system's decorative geometry: points and texts are left out, colours are the page's.
class Animation {
public:
    /// The system must outlive it and have one matter subsystem.
    explicit Animation(const SimTK::MultibodySystem& system, const std::string& title = "Simbody");
    ~Animation();
    Animation(Animation&&) noexcept;
    Animation& operator=(Animation&&) noexcept;

    /// A value to be plotted; to be added before the first frame.
    /// @throws Error after the first frame
    void addCurve(const std::string& name, const std::string& unit,
                  std::function<SimTK::Real(const SimTK::State&)> calc);
    /// Adds a frame. Requires Stage::Position, and what curves require.
    void record(const SimTK::State& state);
    int getNumFrames() const;

    /// @throws Error if there is no frame, the file cannot be written, or not canWriteReports()
    void write(const std::string& path) const;

private:
    class Recording;
    std::unique_ptr<Recording> m_recording;
};

}  // namespace jprim

#endif
