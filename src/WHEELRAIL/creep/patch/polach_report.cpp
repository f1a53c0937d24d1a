// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/result_text.h"
#include "creep/patch/polach_forces.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {

std::string polachJson(const PolachChoice &choice, const PolachContact &contact)
{
  const PolachFit &fit = choice.best;
  const PolachParameters &p = fit.parameters;
  const std::array<double, polachParameters> values = {p.mu0, p.A, p.B, p.kA, p.kS};
  nlohmann::ordered_json json = {{"format", "mca-polach 1"}, {"version", WHEELRAIL_VERSION}};
  json["source"] = "Polach, Wear 258 (2005) 992; spin: Polach, Veh. Syst. Dyn. 33 Suppl. (1999) "
                   "728";
  json["units"] = "B: s/m; shear_modulus: MPa; semi_axes: mm; load: N; others: 1";
  for (int k = 0; k < polachParameters; ++k)
    json[polachParameterNames[k]] = values[k];
  for (int k = 0; k < polachParameters; ++k)
    json["standard_error"][polachParameterNames[k]] = fit.standardError[k];
  json["in_polachs_range"] = p.inPolachsRange(); // kS <= kA <= 1
  json["friction"] = fit.friction == PolachFriction::Falling ? "falling" : "constant";
  json["why"] = choice.reason;
  json["residuals"] = fit.residuals;
  json["rms_force_over_load"] = fit.rms;
  json["worst_force_over_load"] = fit.worst;
  json["points_left_out"] = choice.leftOut;
  json["worst_left_out_over_load"] = choice.worstLeftOut;
  json["warning"] = choice.warning;
  json["condition_number"] = fit.conditionNumber;
  json["contact"] = {{"shear_modulus", contact.shearModulus},
                     {"semi_axes", {contact.a, contact.b}},
                     {"load", contact.load},
                     {"c11", contact.kalker.c11},
                     {"c22", contact.kalker.c22},
                     {"c23", contact.kalker.c23}};
  return jsonText("Polach's law", json);
}

std::string polachCsv(const PolachChoice &choice, const PolachContact &contact,
                      const std::vector<PolachPoint> &points)
{
  std::string text =
      "# creep, lateral: 1; spin: 1/mm; speed: m/s; forces: N, as computed and by Polach's law\n"
      "creep,lateral,spin,speed,load,force_x,force_y,polach_x,polach_y\n";
  for (const PolachPoint &p : points) {
    const PolachForce force = polachForce(choice.best.parameters, contact, p.state);
    text += fmt::format("{:.10g},{:.10g},{:.10g},{:g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g}\n",
                        p.state.creep, p.state.lateral, p.state.spin, p.state.speed, p.state.load,
                        p.forceX, p.forceY, force.x, force.y);
  }
  return text;
}

} // namespace wheelrail
