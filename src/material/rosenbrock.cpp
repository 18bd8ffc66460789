#include "rosenbrock.hpp"

#include <Eigen/LU>

namespace creepcontact::material {
namespace {

constexpr double gamma = 0.25;
constexpr int n_stages = 6;
// The solution is the last stage's argument and its increment, which is the estimated error.
constexpr std::array<double, n_stages> place{0, 0.386, 0.21, 0.63, 1, 1};
constexpr std::array<double, n_stages> by_time{0.25, -0.1043, 0.1035, -0.03620000000000023, 0, 0};
constexpr std::array<std::array<double, n_stages - 1>, n_stages> argument{
    {{},
     {1.544},
     {0.9466785280815826, 0.2557011698983284},
     {3.314825187068521, 2.896124015972201, 0.9986419139977817},
     {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
     {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}}};
constexpr std::array<std::array<double, n_stages - 1>, n_stages> coupling{
    {{},
     {-5.6688},
     {-2.430093356833875, -0.2063599157091915},
     {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
     {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
     {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}}};
constexpr std::array<double, n_stages - 1> to_third{10.12623508344586, -7.487995877610167, -34.80091861555747,
                                                    -7.992771707568823, 1.025137723295662};
constexpr std::array<double, n_stages - 1> to_fourth{-0.6762803392801253, 6.087714651680015, 16.43084320892478,
                                                     24.76722511418386, -6.594389125716872};

}  // namespace

RosenbrockStep::RosenbrockStep(const StiffSystem& system, double t, double h, const Eigen::VectorXd& y) : begin_(y) {
  const Eigen::Index n = y.size();
  Eigen::MatrixXd matrix = -system.jacobian(t, y);
  matrix.diagonal().array() += 1 / (h * gamma);
  const Eigen::PartialPivLU<Eigen::MatrixXd> factor(matrix);
  const double later = t * (1 + 1e-7);
  const Eigen::VectorXd first = system.rate(t, y);
  const Eigen::VectorXd slope = (system.rate(later, y) - first) / (later - t);
  std::array<Eigen::VectorXd, n_stages> k;
  Eigen::VectorXd at = y;
  third_ = fourth_ = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < n_stages; ++i) {
    at = y;
    for (int j = 0; j < i; ++j) at += argument[i][j] * k[j];
    Eigen::VectorXd right = (i == 0 ? first : system.rate(t + place[i] * h, at)) + h * by_time[i] * slope;
    for (int j = 0; j < i; ++j) right += coupling[i][j] / h * k[j];
    k[i] = factor.solve(right);
    if (i == n_stages - 1) break;
    third_ += to_third[i] * k[i];
    fourth_ += to_fourth[i] * k[i];
  }
  error_ = k.back();
  end_ = at + error_;
}

Eigen::VectorXd RosenbrockStep::within(double part) const {
  return (1 - part) * begin_ + part * (end_ + (1 - part) * (third_ + part * fourth_));
}

}  // namespace creepcontact::material
