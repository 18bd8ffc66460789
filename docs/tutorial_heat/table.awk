# Temperatures from the bore to the rim, and the pressure if there is one; rows: powers of ten of the hour, or with -v every=1 all.
BEGIN { FS = ","; if (!every) every = 10 }
NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i }
NR == 2 || NR > 2 && NR % every == 3 % every {
  printf "%6.0f h   %5.1f %5.1f | %5.1f %5.1f degC", $1, $column["bore_temperature"], $column["shaft_temperature"],
         $column["ring_temperature"], $column["rim_temperature"]
  printf "fit_pressure" in column ? sprintf("   %4.1f MPa\n", $column["fit_pressure"]) : "\n"
}
