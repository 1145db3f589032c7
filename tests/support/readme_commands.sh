# shellcheck shell=bash
# The commands of the README. Sourced.

# readme_commands README: the lines of its sh blocks.
readme_commands() { awk '/^ *```sh$/ {inside = 1; next} /^ *```/ {inside = 0} inside && !/^ *(#|$)/' "$1"; }

# The command that a line becomes where `rayscope` is installed: empty for lines that open a window, build, or fetch.
translated() {
    local line=${1%%  #*}
    case $line in
        scripts/run.sh | scripts/run.sh\ view* | scripts/test.sh* | git\ * | cd\ * | cmake\ * | apt*\ * | sudo\ *) ;;
        scripts/package.sh*) ;;
        scripts/run.sh\ *) echo "${line/scripts\/run.sh/rayscope}" ;;
        *) echo "$line" ;;
    esac
}

# run_readme README: runs its commands in the current folder with the `rayscope` in PATH; fails if one fails, or if there are
# fewer than three.
run_readme() {
    local line command count=0
    while read -r line; do
        command=$(translated "$line")
        [[ -n $command ]] || continue
        echo "\$ $command"
        bash -euo pipefail -c "$command" </dev/null || { echo "failed: $line"; return 1; }
        ((++count))
    done < <(readme_commands "$1")
    ((count >= 3)) || { echo "only $count commands were found"; return 1; }
}
