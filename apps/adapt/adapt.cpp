#include "apps/adapt/adapt_planners.h"
#include "apps/commands.h"

namespace swathplan {

Command adapt_command() {
  return {"adapt",
          "The adaptive side-scan planners: simulate a mission, study many, or plan live",
          {},
          {},
          {adapt_accordion_command(), adapt_spacing_command(), adapt_quality_command()}};
}

}  // namespace swathplan
