// Tangent frames in the linear model: where an Offset's frame lies when a space is seen as a whole.
//
// Model points P = (x, y, z) satisfy <P, P> = 1 with <P, Q> = z z' + kappa (x x' + y y'); vectors T
// tangent at P have <P, T> = 0 and the metric g(S, T) = S_x T_x + S_y T_y + kappa S_z T_z. A point
// with offset (x, y, h) in the frame (P, E1, E2) is P + x E1 + y E2 - kappa h P. One code for the
// three spaces; kappa is a number in the formulas. Doubles resolve a place at distance r from the
// model's own origin to about 1e-16 cosh^2 r on the hyperboloid. docs/tangent-quadric.md.
#pragma once

#include "space/offset.h"
#include "ucvt/spaces.h"

namespace ucvt {

/// An orthonormal tangent frame. The second axis follows from the first: E2 = diag(1, 1, kappa)
/// (P x E1). As it stands, the frame at the model's own origin.
struct Frame {
  double kappa = 0;
  ModelPoint P{0, 0, 1};
  ModelPoint E1{1, 0, 0};

  // NOLINTNEXTLINE(readability-identifier-naming): named like E1
  [[nodiscard]] ModelPoint E2() const;
};

/// The nearest point of the model to a point off it by rounding: by x and y where they tell it.
ModelPoint on_model(double kappa, const ModelPoint& p);

/// The model point at an offset in the frame.
ModelPoint model_point(const Frame& f, const Offset& x);

/// The offset of a model point in the frame, from differences: relative error about 1e-16 cosh^2 r
/// however near it is (FrameTest.NearPointsKeepTheirDigits). Requires it to lie on the model.
Offset offset_in(const Frame& f, const ModelPoint& p);

/// The same frame with P on the model, E1 tangent and of unit length again.
Frame orthonormal(const Frame& f);

/// The frame carried parallel along the geodesic to an offset: what `transvect` calls the frame at
/// `to`. Requires `to` not to be the antipode.
Frame carried(const Frame& f, const Offset& to);

/// The frame at a model point: the one at (0, 0, 1) carried there, on the lower half of the sphere
/// the one at (0, 0, -1) with the same first axis.
Frame frame_at(double kappa, const ModelPoint& p);

/// The frame turned about its origin, counterclockwise.
Frame turned(const Frame& f, const Rotation& by);

/// The isometry of the model that takes one frame to the other. Requires the same kappa.
ModelMatrix taking(const Frame& from, const Frame& to);

/// M P.
ModelPoint transformed(const ModelMatrix& m, const ModelPoint& p);

/// The inverse of an isometry of the model that preserves orientation.
ModelMatrix inverse_isometry(double kappa, const ModelMatrix& m);

}  // namespace ucvt
