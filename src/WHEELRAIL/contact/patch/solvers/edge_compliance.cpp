// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/edge_compliance.h"

#include "contact/edge_share.h"
#include "shared/pi.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

using mcawr::pi;
constexpr double panelShift = 0.25; ///< of a cell: see the header
constexpr double flattest = 0.1;    ///< cosine: edges along x hardly matter
constexpr int reach = 2;            ///< cells around an edge that its direction is taken from

struct Direction {
  double x, y;
};

class Edges {
 public:
  Edges(const PatchGrid &grid, const ElasticPair &pair, const Vector &pressure, const Vector &gap)
      : grid_(grid), pressure_(pressure), gap_(gap), modulus_(pair.G / (1.0 - pair.nu)),
        highest_(pressure.maxCoeff())
  {
  }

  bool touches(int ix, int iy) const
  {
    return ix >= 0 && ix < grid_.nx && iy >= 0 && iy < grid_.ny &&
           pressure_[grid_.index(ix, iy)] > 0.0;
  }

  /// Outward normal of the edge at a cell: away from the middle of the cells in contact around it.
  Direction normal(int ix, int iy) const
  {
    double x = 0.0, y = 0.0;
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i)
        if (i * i + j * j <= (reach + 0.5) * (reach + 0.5) && touches(ix + i, iy + j))
          x -= i, y -= j;
    x /= grid_.dx; // the normal of a straight edge in cells that are not square
    y /= grid_.dy;
    const double length = std::hypot(x, y);
    return length > 0.0 ? Direction{x / length, y / length} : Direction{1.0, 0.0};
  }

  /// How far the contact reaches beyond the centre of its last cell along x, in cells.
  /// \param step 1: towards larger x, -1: towards smaller
  double reachBeyond(int ix, int iy, int step, double cosine) const
  {
    const int last = grid_.index(ix, iy), next = ix + step;
    // At a hardness limit the pressure has no root, and it is the highest there is.
    if (next < 0 || next >= grid_.nx || pressure_[last] >= highest_)
      return 0.5;
    const double way = grid_.dx * std::max(cosine, flattest);
    return 1.0 - shareApart(pressure_[last] / modulus_, gap_[last + step] / way);
  }

 private:
  const PatchGrid &grid_;
  const Vector &pressure_, &gap_;
  double modulus_, highest_;
};

} // namespace

// A leading cell is one in contact whose neighbour at larger x is not. It gets a compliance in
// three steps: the outward normal of the edge there; how far the contact reaches into it, from the
// square-root edge of pressure and gap; and the share of its panel that is in contact, which says
// how much softer it is (header). A panel reaches from 1/4 of a cell behind the centre to 3/4 ahead
// of it; a contact that ends at the cell's face has the share 3/4 of it. Edges whose normal points
// backwards trail. Compliances across and along the edge are turned from its normal into x and y.
EdgeCompliance edgeCompliance(const PatchGrid &grid, const ElasticPair &pair,
                              const Vector &pressure, const Vector &gap)
{
  const Vector zero = Vector::Zero(grid.cells());
  EdgeCompliance edge{zero, zero, zero};
  const Edges edges(grid, pair, pressure, gap);
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      if (!edges.touches(ix, iy) || edges.touches(ix + 1, iy))
        continue;
      const Direction n = edges.normal(ix, iy);
      if (n.x <= 0.0)
        continue;
      const double ahead = edges.reachBeyond(ix, iy, 1, n.x);
      const bool single = !edges.touches(ix - 1, iy);
      const double share =
          single ? ahead + edges.reachBeyond(ix, iy, -1, n.x) : ahead + 0.5 - panelShift;
      const double compliance =
          (single ? 4.0 / pi : 2.0) * (1.0 - share) / share * grid.dx * n.x / pair.G;
      const int cell = grid.index(ix, iy);
      edge.xx[cell] = compliance * (1.0 - pair.nu * n.x * n.x);
      edge.yy[cell] = compliance * (1.0 - pair.nu * n.y * n.y);
      edge.xy[cell] = -compliance * pair.nu * n.x * n.y;
    }
  return edge;
}

} // namespace wheelrail
