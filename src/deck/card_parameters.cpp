#include "card_parameters.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <utility>

#include "creepcontact/deck/cards.hpp"

namespace creepcontact::deck {
namespace {

using Use = Parameter::Use;
using Names = std::initializer_list<const char*>;
using List = std::vector<Parameter>;

List with(Use use, Names names, const std::string& text = {}) {
  List list;
  for (const char* name : names) list.push_back({name, use, {}, text});
  return list;
}
List taken(Names names) {
  return with(Use::taken, names);
}
List one_of(const char* name, Names values) {
  return {{name, Use::taken, {values.begin(), values.end()}, {}}};
}
/// Values that are the default, and so change nothing.
List only(const char* name, Names values) {
  return {{name, Use::ignored, {values.begin(), values.end()}, {}}};
}
List ignored(Names names) {
  return with(Use::ignored, names);
}
List left_out(Names names, const std::string& text) {
  return with(Use::left_out, names, text);
}
List refused(Names names, const std::string& text) {
  return with(Use::impossible, names, text);
}

List operator+(List a, const List& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const char* const of_users = "subroutines of users are not known";
const char* const of_files = "data in files of their own are not known; *INCLUDE is";
const char* const of_results = "values from the results of another run are not known";
const char* const of_shifted_time = "a total time that is set again is not known";

List of_table() {
  return only("DEPENDENCIES", {"0"}) + refused({"USER"}, of_users);
}
/// The parameters of loads and supports, which an amplitude multiplies.
List of_loads() {
  return taken({"AMPLITUDE"}) + one_of("OP", {"NEW", "MOD"}) + only("LOAD CASE", {"1"}) + ignored({"REAL"}) +
         refused({"TIME DELAY"}, "amplitudes that begin later are not known; give their table shifted in time") +
         refused({"USER"}, of_users) + refused({"SUBMODEL", "STEP", "DATA SET", "FILE"}, of_results) +
         refused({"IMAGINARY", "SECTOR", "CYCLIC MODE", "REGION TYPE"},
                 "it has no meaning in *STATIC and *VISCO steps");
}
/// The parameters of flows of heat whose second value has an amplitude of its own.
List of_exchange(const char* own_amplitude, const char* own_delay) {
  return of_loads() + taken({own_amplitude}) +
         refused({own_delay}, "amplitudes that begin later are not known; give their table shifted in time") +
         refused({"FORCED CONVECTION"}, "fluids that flow are not known") +
         refused({"CAVITY", "ENVNODE"}, "radiation between surfaces is not known, only to surroundings");
}
List of_following_loads() {
  return left_out({"FOLLOWER"}, "directions of loads are those of the undeformed bodies");
}
List of_procedure() {
  return ignored({"DIRECT", "SOLVER", "ALLSDTOL", "CONTINUE", "FACTOR", "INITIAL"}) +
         left_out({"STABILIZE"}, "there is no artificial damping") +
         refused({"TIME RESET", "TOTAL TIME AT START"}, of_shifted_time);
}
List of_prints() {
  return taken({"NSET", "ELSET"}) + ignored({"FREQUENCY", "FREQUENCYF", "TIME POINTS", "TOTALS", "GLOBAL", "OUTPUT",
                                             "POSITION", "SUMMARY", "AVERAGE", "MODE", "LAST MODE", "FORMAT"});
}

std::map<std::string, List> lists() {
  std::map<std::string, List> of;
  // Geometry
  of["NODE"] = taken({"NSET"}) + only("SYSTEM", {"R"}) + refused({"INPUT"}, of_files);
  of["ELEMENT"] = taken({"TYPE", "ELSET"}) + refused({"INPUT", "FILE"}, of_files);
  of["NSET"] = taken({"NSET", "GENERATE", "INSTANCE"}) + ignored({"UNSORTED", "INTERNAL"}) +
               left_out({"FREQUENCY"}, "it counts for output only") + taken({"ELSET"});
  of["ELSET"] = taken({"ELSET", "GENERATE", "INSTANCE"}) + ignored({"UNSORTED", "INTERNAL"}) +
                left_out({"FREQUENCY"}, "it counts for output only");
  of["SURFACE"] = taken({"NAME"}) + one_of("TYPE", {"ELEMENT", "NODE"}) + ignored({"INTERNAL"}) +
                  left_out({"NO OFFSET", "NO THICK"}, "shells are not known");
  of["SOLID SECTION"] = taken({"ELSET", "MATERIAL", "ORIENTATION"}) +
                        ignored({"CONTROLS", "SYMMETRIC", "STACK DIRECTION", "ORDER"}) +
                        left_out({"OFFSET"}, "an offset counts for shells only") +
                        refused({"REF NODE"},
                                "loads and supports of generalised plane strain are not taken from a reference node; "
                                "remove it if there are none") +
                        refused({"COMPOSITE"}, "layers are not known; a section for each of them is");
  of["GASKET SECTION"] = taken({"ELSET", "BEHAVIOR", "MATERIAL"}) + ignored({"ORIENTATION"}) +
                         left_out({"STABILIZATION STIFFNESS"}, "there is no artificial stiffness");
  of["GASKET BEHAVIOR"] = taken({"NAME"});
  of["GASKET THICKNESS BEHAVIOR"] = taken({"SLOPE DROP", "YIELD ONSET"}) + of_table() +
                                    one_of("DIRECTION", {"LOADING", "UNLOADING"}) +
                                    one_of("TYPE", {"ELASTIC-PLASTIC", "DAMAGE"}) + one_of("VARIABLE", {"STRESS"}) +
                                    ignored({"TENSILE STIFFNESS FACTOR"});
  // Materials
  of["MATERIAL"] = taken({"NAME"}) + ignored({"RTOL", "SRATE FACTOR", "STRAIN RATE REGULARIZATION"});
  of["ELASTIC"] = taken({"TYPE"}) + of_table() + only("MODULI", {"INSTANTANEOUS", "LONG TERM"});
  of["EXPANSION"] = taken({"TYPE", "ZERO"}) + of_table();
  of["POTENTIAL"] = of_table();
  of["DENSITY"] = of_table();
  of["CONDUCTIVITY"] = taken({"TYPE"}) + of_table();
  of["SPECIFIC HEAT"] = of_table();
  of["CREEP"] = taken({"LAW"}) + of_table() + one_of("TIME", {"TOTAL", "CREEP"});
  of["PLASTIC"] = taken({"NUMBER BACKSTRESSES"}) + of_table() +
                  one_of("HARDENING", {"ISOTROPIC", "KINEMATIC", "COMBINED"}) + one_of("DATA TYPE", {"PARAMETERS"}) +
                  only("EXTRAPOLATION", {"CONSTANT"}) +
                  refused({"RATE", "SCALESTRESS"}, "rates and scales of the yield stress are not known");
  of["CYCLIC HARDENING"] =
      of_table() + refused({"PARAMETERS"}, "Q and b are not known; a table of the stress over the plastic strain is") +
      refused({"RATE"}, "rates of the yield stress are not known");
  of["PHYSICAL CONSTANTS"] =
      taken({"ABSOLUTE ZERO", "STEFAN BOLTZMANN"}) + ignored({"NEWTON GRAVITY", "UNIVERSAL GAS CONSTANT"});
  of["ORIENTATION"] = taken({"NAME", "SYSTEM", "DEFINITION"}) + ignored({"LOCAL DIRECTIONS"});
  of["AMPLITUDE"] = taken({"NAME", "SHIFTX", "SHIFTY"}) + one_of("TIME", {"STEP TIME", "TOTAL TIME"}) +
                    one_of("DEFINITION", {"TABULAR"}) + one_of("VALUE", {"RELATIVE"}) + only("SMOOTH", {"0", "0."}) +
                    refused({"USER"}, of_users) + refused({"INPUT"}, of_files);
  // Parts
  of["PART"] = taken({"NAME"});
  of["INSTANCE"] = taken({"NAME", "PART"}) + refused({"INSTANCE", "LIBRARY"}, of_results);
  // Steps
  of["STEP"] = taken({"NLGEOM"}) + one_of("AMPLITUDE", {"RAMP", "STEP"}) +
               ignored({"INC", "INCF", "NAME", "EXTRAPOLATION", "UNSYMM", "SOLVER", "CONVERT SDI"}) +
               refused({"PERTURBATION"}, "linear perturbation is not known");
  of["STATIC"] =
      of_procedure() + refused({"RIKS", "ADIABATIC", "FULLY PLASTIC", "LONG TERM"}, "this procedure is not known");
  of["NO ANALYSIS"] = {};
  of["VISCO"] = of_procedure() + ignored({"CETOL"}) + one_of("CREEP", {"EXPLICIT"});
  const List of_heat_steps = taken({"STEADY STATE"}) +
                             ignored({"DIRECT", "SOLVER", "DELTMX", "MXDEM", "FACTOR", "CETOL"}) +
                             one_of("END", {"PERIOD"}) + refused({"TOTAL TIME AT START"}, of_shifted_time);
  of["HEAT TRANSFER"] =
      of_heat_steps + taken({"TIME RESET"}) +
      refused({"FREQUENCY", "MODAL DYNAMIC", "STORAGE", "GLOBAL"}, "modes of vibration and of sound are not known");
  for (const char* card : {"COUPLED TEMPERATURE-DISPLACEMENT", "UNCOUPLED TEMPERATURE-DISPLACEMENT"})
    of[card] = of_heat_steps + taken({"TIME RESET"}) + ignored({"ALPHA"}) + one_of("CREEP", {"EXPLICIT"}) +
               left_out({"STABILIZE"}, "there is no artificial damping") +
               refused({"ELECTRICAL"}, "heat of currents is not known");
  of["RESTART"] = ignored({"WRITE", "FREQUENCY", "OVERLAY", "NUMBER INTERVAL", "TIME MARKS", "STEP", "INC"}) +
                  refused({"READ"}, "the deck goes on from the results of another one");
  // Supports and loads
  of["BOUNDARY"] = of_loads() + one_of("TYPE", {"DISPLACEMENT"}) + taken({"FIXED"}) +
                   refused({"MASS FLOW", "PRESSURE", "TEMPERATURE"},
                           "only displacements and, as degree of freedom 11, temperatures are prescribed");
  of["CLOAD"] = of_loads() + of_following_loads();
  of["DLOAD"] = of_loads() + of_following_loads() + only("CONSTANT RESULTANT", {"NO"});
  of["DSLOAD"] = of_loads() + of_following_loads() + only("CONSTANT RESULTANT", {"NO"});
  of["TEMPERATURE"] = of_loads() +
                      refused({"BSTEP", "BINC", "ESTEP", "EINC", "INTERPOLATE", "DRIVING ELSETS"}, of_results) +
                      refused({"INPUT"}, of_files);
  for (const char* card : {"CFLUX", "DFLUX", "DSFLUX"}) of[card] = of_loads();
  for (const char* card : {"FILM", "SFILM"}) of[card] = of_exchange("FILM AMPLITUDE", "FILM TIME DELAY");
  for (const char* card : {"RADIATE", "SRADIATE"})
    of[card] = of_exchange("RADIATION AMPLITUDE", "RADIATION TIME DELAY");
  of["INITIAL CONDITIONS"] = taken({"TYPE"}) + refused({"USER"}, of_users) +
                             refused({"FILE", "STEP", "INC", "INTERPOLATE", "DRIVING ELSETS"}, of_results) +
                             refused({"INPUT"}, of_files);
  // Contact
  of["CONTACT PAIR"] = taken({"INTERACTION", "ADJUST", "TIED"}) +
                       one_of("TYPE", {"SURFACE TO SURFACE", "NODE TO SURFACE", "MORTAR", "LINMORTAR", "PGLINMORTAR"}) +
                       ignored({"SMALL SLIDING", "HCRIT", "SMOOTH", "TRACKING", "SUPPLEMENTARY CONSTRAINTS",
                                "MECHANICAL CONSTRAINT", "NO THICKNESS", "GEOMETRIC CORRECTION"}) +
                       left_out({"EXTENSION ZONE"}, "surfaces end where they end") +
                       refused({"CPSET"}, "properties in sets are not known; INTERACTION is");
  of["SURFACE INTERACTION"] = taken({"NAME"}) + ignored({"UNSYMM"}) + refused({"USER"}, of_users);
  of["SURFACE BEHAVIOR"] =
      one_of("PRESSURE-OVERCLOSURE", {"HARD", "LINEAR", "EXPONENTIAL", "TABULAR", "TIED"}) +
      ignored({"AUGMENTED LAGRANGE", "DIRECT", "LAGRANGE", "PENALTY"}) +
      refused({"NO SEPARATION"}, "surfaces that hold each other once they touch, and slide, are not known");
  of["SPRING"] = taken({"ELSET", "NONLINEAR"}) + of_table() + ignored({"RTOL"}) +
                 refused({"ORIENTATION"}, "springs along axes of their own are not known") +
                 refused({"COMPLEX STIFFNESS"}, "damping is not known");
  of["KINEMATIC COUPLING"] =
      taken({"REF NODE"}) + refused({"ORIENTATION"}, "couplings along axes of their own are not known");
  of["MASS"] = taken({"ELSET"}) + ignored({"ALPHA", "COMPOSITE"}) +
               refused({"TYPE", "ORIENTATION"}, "masses that differ along axes are not known");
  of["FRICTION"] =
      ignored({"ELASTIC SLIP", "SLIP TOLERANCE", "SHEAR TRACTION SLOPE", "LAGRANGE"}) + of_table() +
      refused({"ROUGH"},
              "friction without a limit is not known; give a coefficient, or TIED if the surfaces neither "
              "slide nor open") +
      refused({"TAUMAX"}, "friction with a largest traction is not known") +
      refused({"ANISOTROPIC"}, "friction that depends on the direction is not known") +
      refused({"EXPONENTIAL DECAY", "TEST DATA"}, "friction that depends on the rate of slip is not known");
  of["CHANGE FRICTION"] = taken({"INTERACTION"}) + refused({"RESET", "AMPLITUDE"},
                                                           "friction that changes by itself is not known; a *FRICTION "
                                                           "below gives its new value");
  of["MODEL CHANGE"] = List{{"TYPE", Use::taken, {"CONTACT PAIR"}, {}}} + taken({"REMOVE", "ADD"});
  of["GAP CONDUCTANCE"] =
      taken({"PRESSURE"}) + of_table() + refused({"MASS FLOW RATE"}, "flowing fluids are not known");
  of["CLEARANCE"] = taken({"MASTER", "SLAVE", "VALUE"}) +
                    refused({"CPSET", "TABULAR", "BOLT"}, "only one clearance of two surfaces, VALUE, is known");
  of["TIE"] =
      taken({"NAME", "POSITION TOLERANCE", "CYCLIC SYMMETRY"}) +
      ignored({"ADJUST", "NO ROTATION", "NO THICKNESS", "TYPE"}) +
      refused({"FLUID PERIODIC", "FLUID CYCLIC", "MULTISTAGE"}, "only ties of surfaces and cyclic symmetry are known") +
      refused({"TIED NSET", "CONSTRAINT RATIO"}, "ties of a part of a surface are not known");
  of["CONTACT"] = only("OP", {"NEW"});
  of["CONTACT INCLUSIONS"] = taken({"ALL EXTERIOR"});
  of["CONTACT EXCLUSIONS"] = {};
  of["CONTACT PROPERTY ASSIGNMENT"] = {};
  // Constraints
  of["CYCLIC SYMMETRY MODEL"] = taken({"N", "TIE"}) + ignored({"NGRAPH", "ELSET", "CHECK"});
  of["EQUATION"] = refused({"REMOVE", "REMOVE ALL"}, "constraints that change from step to step are not known") +
                   refused({"INPUT"}, of_files);
  of["MPC"] = refused({"USER", "MODE"}, of_users) + refused({"INPUT"}, of_files);
  of["TRANSFORM"] = taken({"NSET"}) + one_of("TYPE", {"R", "C"});
  of["PRE-TENSION SECTION"] =
      taken({"SURFACE", "NODE"}) + refused({"ELEMENT"}, "only sections that are a SURFACE of solid elements are known");
  of["RIGID BODY"] = taken({"NSET", "ELSET", "REF NODE", "ROT NODE", "TIE NSET", "PIN NSET"}) +
                     only("POSITION", {"INPUT"}) + ignored({"ISOTHERMAL"}) +
                     refused({"ANALYTICAL SURFACE"}, "analytical surfaces are not known");
  of["COUPLING"] = taken({"REF NODE", "SURFACE"}) + ignored({"CONSTRAINT NAME"}) +
                   refused({"INFLUENCE RADIUS"}, "couplings are those of whole surfaces") +
                   refused({"ORIENTATION"}, "components of couplings are those along x, y and z");
  of["KINEMATIC"] = {};
  of["DISTRIBUTING"] = one_of("WEIGHTING METHOD", {"UNIFORM"}) + one_of("COUPLING", {"CONTINUUM"});
  of["NODE PRINT"] = of_prints();
  of["EL PRINT"] = of_prints();
  for (const char* card : {"END STEP", "END PART", "END INSTANCE"}) of[card] = {};
  return of;
}

}  // namespace

std::string letters_of(const std::string& text) {
  std::string result;
  std::ranges::copy_if(upper_case(text), std::back_inserter(result), [](char c) { return c != ' ' && c != '\t'; });
  return result;
}

const std::map<std::string, Parameter>* parameters_of(const std::string& card) {
  static const std::map<std::string, std::map<std::string, Parameter>> all = [] {
    std::map<std::string, std::map<std::string, Parameter>> result;
    for (const auto& [name, list] : lists()) {
      result[name];
      for (const Parameter& parameter : list) result[name].emplace(letters_of(parameter.name), parameter);
    }
    return result;
  }();
  const auto found = all.find(card);
  return found == all.end() ? nullptr : &found->second;
}

}  // namespace creepcontact::deck
