#include "further_laws.h"

#include "laws/plane.h"

namespace mca {

static StressTensor averaged(const double *stresses, const double *response, int i)
{
  const double *row = stresses + stressRow * i;
  return automatonStress(row[0], row[1], row[2], response[responseRow * i]);
}

void addElasticZ(int n, const int *type, const AutomatonLaw *laws, const double *elasticZ,
                 double *response)
{
  for (int i = 0; i < n; i++)
    response[responseRow * i] += laws[type[i]].bulkModulus * elasticZ[i];
}

void flowElasticZ(int n, const int *type, const AutomatonLaw *laws, const double *strains,
                  const double *stresses, const double *response, const double *elasticZ,
                  double *elasticZNext)
{
  for (int i = 0; i < n; i++) {
    const double mean = response[responseRow * i], factor = response[responseRow * i + 1];
    const bool holds = strains[strainRow * i + 1] > 0.0;
    const double after = elasticZAfter(elasticZ[i], averaged(stresses, response, i).zz, mean,
                                       factor, 2.0 * laws[type[i]].shearModulus);
    elasticZNext[i] = holds ? after : 0.0;
  }
}

void showLocal(int n, const int *type, const AutomatonLaw *laws, const double *stresses,
               const double *response, const double *kappa, const double *kappaNext, double *local)
{
  for (int i = 0; i < n; i++) {
    const StressTensor s = averaged(stresses, response, i);
    const double mean = response[responseRow * i], factor = response[responseRow * i + 1];
    const YieldCurve &curve = laws[type[i]].curve;
    double *row = local + localRow * i;
    row[0] = mean + factor * (s.xx - mean);
    row[1] = mean + factor * (s.yy - mean);
    row[2] = factor * s.xy;
    row[3] = curve.work(kappaNext[i]) - curve.work(kappa[i]);
  }
}

} // namespace mca
