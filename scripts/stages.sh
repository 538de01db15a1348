# Sourced by .ci/run and scripts/proof, from the root: runs their stages, functions named stage_NAME, one after the other.
# Goes on after a stage that fails, so that one run shows all that is wrong.

# run_stages NAME...: prints each stage with its time by the clock and its processor time, then the compile steps that
# took longest, then both once more as a table. The exit code is 1 if a stage failed.
run_stages() {
  local summary="" failures=0 seconds=0 work=0 stage status verdict line timing
  timing=$(mktemp)
  # shellcheck disable=SC2064  # this file, whatever the variable is later
  trap "rm -f '$timing'" EXIT
  for stage in "$@"; do
    printf '\n== %s\n' "$stage"
    # A shell of its own, so that the first command that fails ends the stage; `if` or `||` would switch that off.
    set +e
    { TIMEFORMAT='%0R %0U %0S'; time { (set -e; "stage_$stage") 2>&3; }; } 3>&2 2>"$timing"
    status=$?
    set -e
    read -r clock user system < <(tail -n 1 "$timing")
    seconds=$((seconds + clock)) work=$((work + user + system))
    verdict=passed
    [ $status -eq 0 ] || { verdict=FAILED; failures=$((failures + 1)); }
    line=$(printf '%-10s %-7s %5d s, %5d s of processors' "$stage" "$verdict" "$clock" $((user + system)))
    printf '== %s\n' "$line"
    summary+="$line"$'\n'
  done
  slowest_steps
  verdict=passed
  [ $failures -eq 0 ] || verdict=FAILED
  printf '\n%s%-10s %-7s %5d s, %5d s of processors\n' "$summary" total "$verdict" "$seconds" "$work"
  [ $failures -eq 0 ]
}

# The ten steps of all builds that took longest, from ninja's logs: start and end in ms, and what was made.
slowest_steps() {
  local logs
  mapfile -t logs < <(find build -maxdepth 2 -name .ninja_log | sort)
  [ ${#logs[@]} -gt 0 ] || return 0
  printf '\nThe longest steps of the builds:\n'
  awk -F '\t' 'NF >= 4 {split(FILENAME, part, "/"); printf "%7.1f s  %s  %s\n", ($2 - $1) / 1000, part[2], $4}' "${logs[@]}" |
    sort -rn | sed -n '1,10s#CMakeFiles/\([^ ]*\)\.dir/#\1: #; 1,10p'
}
