#pragma once
/// Pieces of build_model: each turns one kind of configuration entry into its counterpart in the model.

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"
#include "creepcontact/model/error_collector.hpp"
#include "creepcontact/model/materials.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/model/numbered_nodes.hpp"
#include "shared_couplings.hpp"

namespace creepcontact::model {

struct SearchedFunction;  // function_search.hpp
struct MotionEquation;    // model_links.hpp

/// Reads or makes the mesh, with the surfaces that the configuration names. @throws ModelError, with the place in the
/// configuration if there is no such file
mesh::Mesh read_mesh(const config::Config& config);

std::optional<mechanics::MaterialAxes> material_axes(const config::Body& body);

using Bodies = std::vector<mechanics::Body>;
/// Meshes of the bodies, in the order of the configuration.
using BodyMeshes = std::vector<mesh::Mesh>;

/// Bodies named by `body`, or else all that have the group. @throws ModelError if there is none
std::vector<std::size_t> bodies_on(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                                   const std::string& group, const config::Reference& body, int dimension);
std::size_t body_index(const config::Config& config, const std::string& name);

inline Vector3 vector(const std::array<double, 3>& from) {
  return {from[0], from[1], from[2]};
}

/// Looks for the surfaces of all loads and contacts, so that a name mistyped there shows with all other mistakes.
void check_groups(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                  ErrorCollector& errors);

/// @throws ModelError if the mesh of a body has elements that lock
void refuse_locking(const std::string& body, const mesh::Mesh& mesh);

/// Conditions that one [[supports]] entry puts on a body.
std::vector<mechanics::Support> make_supports(const config::Support& support, const mesh::Mesh& body);

/// Generalised plane strain: supports that give the axial strain, if it is prescribed. Otherwise nothing.
void prescribe_axial_strain(const config::Config& config, const BodyMeshes& meshes,
                            std::vector<std::vector<mechanics::Support>>& supports);
/// Generalised plane strain with an unknown axial strain: the axial force as a load, and, unless each body has its own,
/// ties that make the strain the same in all bodies. Otherwise nothing.
void share_axial_strain(const config::Config& config, Bodies& bodies, std::vector<contact::Pair>& pairs);

/// [[equations]], those of motions, and supports that act for a time, as pairs of bodies, without those that follow
/// from others or that supports fulfil. Errors name the place in the configuration: a node that no body has, equations
/// between three bodies, or that contradict each other.
void append_equations(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                      const Bodies& bodies, const std::vector<MotionEquation>& motions,
                      std::vector<contact::Pair>& pairs, ErrorCollector& errors);

void add_load(const config::Load& load, const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
              Bodies& bodies);

std::vector<std::shared_ptr<const material::CreepLaw>> make_creep_laws(const std::vector<config::CreepMechanism>& from);

/// What a gasket or a spring is made of for its creep; null without laws.
std::shared_ptr<const material::Material> creep_alone(const std::string& name,
                                                      std::vector<std::shared_ptr<const material::CreepLaw>> laws,
                                                      double reference_temperature = 0);
/// Area that a node of a body has on its surface, about.
double nodal_area(const mechanics::Body& body);

/// Gaskets by their names.
using GasketKinds = std::map<std::string, std::shared_ptr<const contact::GasketKind>>;
/// @throws ModelError naming the points of a curve that is not possible
std::shared_ptr<const contact::GasketKind> make_gasket(const config::Gasket& from);
/// Warns of gaskets whose creep is known for a shorter time than that of the run, and of curves that seem to be in
/// other units than the bodies.
void warn_of_gaskets(const config::Config& config, const Bodies& bodies);

/// Appends the springs as pairs of their names.
void append_springs(const config::Config& config, const Bodies& bodies, std::vector<contact::Pair>& pairs,
                    ErrorCollector& errors);

/// The surfaces are on bodies (check_groups).
/// @param gaskets  all of the configuration
/// @param sliding  relative motions that the pair leaves free exactly
contact::Pair make_pair(const config::Contact& contact, const config::Config& config, const Bodies& bodies,
                        const std::optional<mechanics::TemperatureField>& temperature, const GasketKinds& gaskets,
                        const SharedCouplings& couplings, std::span<const mechanics::RigidMotion> sliding);

/// Discontinuities in time of every function of the configuration and the times at which it turns back, the points of
/// tables, the ends of cycles, and the user's own breakpoints; ascending, within (0, end).
/// @param functions  of search_functions
std::vector<double> breakpoints(const config::Config& config, std::span<const SearchedFunction> functions,
                                const std::optional<mechanics::TemperatureField>& temperature);

/// @throws ConfigError if the integrator does not take the laws of the materials
void require_one_theory(const config::Config& config, const Bodies& bodies);

}  // namespace creepcontact::model
