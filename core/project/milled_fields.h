// The figures of a milled part's report, each declared once (report_fields.h).
#pragma once

#include "project/milled_report.h"
#include "project/report_fields.h"

namespace voluta::project {

constexpr auto fieldsOf(std::type_identity<LaidDownReport>) {
  using R = LaidDownReport;
  return std::tuple{Field{"quaternion", &R::quaternion}, Field{"rounds", &R::rounds},
                    Field{"scrapBeforeMm3", &R::scrapBeforeMm3, "mm³"},
                    Field{"scrapMm3", &R::scrapMm3, "mm³"}};
}
constexpr auto fieldsOf(std::type_identity<MillingReport>) {
  using R = MillingReport;
  return std::tuple{Field{"material", &R::material},
                    Field{"cutterMm", &R::cutterMm, "mm"},
                    Field{"teeth", &R::teeth},
                    Field{"rpm", &R::rpm},
                    Field{"feedMmPerMin", &R::feedMmPerMin},
                    Field{"lineMm", &R::lineMm, "mm"},
                    Field{"finePassMm", &R::finePassMm, "mm"},
                    Field{"blockMm", &R::blockMm, "mm"},
                    Field{"laidDown", &R::millingOrientation},
                    Field{"moves", &R::moves},
                    Field{"removedMm3", &R::removedMm3, "mm³"},
                    Field{"deepestMm", &R::deepestMm, "mm"},
                    Field{"residueMm", &R::residueMm, "mm"},
                    Field{"complete", &R::complete},
                    Field{"leftMm3", &R::leftMm3, "mm³"},
                    Field{"leftThickestMm", &R::leftThickestMm, "mm"},
                    Field{"leftAtMm", &R::leftAtMm, "mm"},
                    Field{"cornersMm3", &R::cornersMm3, "mm³"}};
}
constexpr auto fieldsOf(std::type_identity<MilledReport>) {
  using R = MilledReport;
  return std::tuple_cat(fieldsOf(std::type_identity<VerdictReport>{}),
                        std::tuple{Field{"model", &R::model}, Field{"milling", &R::milling},
                                   Field{"programs", &R::programs}, Field{"replay", &R::replay},
                                   Field{"findings", &R::findings}, Field{"timingS", &R::timings},
                                   Field{"peakRssMb", &R::peakRssMb, "MB"},
                                   Field{"threads", &R::threads}});
}

} // namespace voluta::project
