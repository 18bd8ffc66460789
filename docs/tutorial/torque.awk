BEGIN { FS = "," }
NR == 2 { start = $2 }
NR == 2 || NR % 4 == 3 {
  torque = 0.12*$2*2*3.14159*60^2*40/1e6
  printf "%6.0f h %6.1f MPa %6.2f kN m %6.1f %%\n", $1, $2, torque, 100*$2/start
}
