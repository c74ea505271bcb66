#include "cvt/convex_hull.h"

#include <cstdio>
#include <memory>
#include <string>

extern "C" {
#include <libqhull_r/libqhull_r.h>
#include <libqhull_r/mem_r.h>
#include <libqhull_r/qset_r.h>
}

namespace ucvt {
namespace {

/// Qhull's state, freed in the end; what it has to say about failures goes nowhere.
class Hull {
 public:
  Hull() { qh_zero(&qh_, log_.get()); }
  Hull(const Hull&) = delete;
  Hull& operator=(const Hull&) = delete;
  ~Hull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int kept = 0, total = 0;
    qh_memfreeshort(&qh_, &kept, &total);
  }

  /// False when there is no hull of full dimension.
  bool build(std::vector<std::array<double, 3>>& points) {
    std::string command = "qhull Qt Pp";
    return log_ && !points.empty() &&
           qh_new_qhull(&qh_, 3, static_cast<int>(points.size()), points.front().data(), 0,
                        command.data(), nullptr, log_.get()) == 0;
  }

  std::vector<HullTriangle> triangles() {
    std::vector<HullTriangle> out;
    for (const facetT* f = qh_.facet_list; f != nullptr && f->next != nullptr; f = f->next) {
      HullTriangle t{{}, {f->normal[0], f->normal[1], f->normal[2]}};
      for (int i = 0; i < 3; ++i) {
        const auto* v = static_cast<const vertexT*>(f->vertices->e[i].p);
        t.corner[static_cast<std::size_t>(i)] = qh_pointid(&qh_, v->point);
      }
      out.push_back(t);
    }
    return out;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> log_{std::fopen("/dev/null", "w")};
  qhT qh_;
};

}  // namespace

std::vector<HullTriangle> convex_hull(std::vector<std::array<double, 3>> points) {
  Hull hull;
  return hull.build(points) ? hull.triangles() : std::vector<HullTriangle>{};
}

}  // namespace ucvt
