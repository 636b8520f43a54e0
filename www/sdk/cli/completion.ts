/**
 * `kerfway completion`: scripts that make bash, zsh and fish complete commands, options and their values. They are made
 * from the table of commands and from the current names of machines and methods.
 */

import { createPlanner } from '../node.js';
import { oneWord, oneOf, parsed } from './arguments.js';
import { COMMANDS, optionsOf, type Command } from './commands.js';
import { print } from './io.js';
import { SHELLS, type Choices, type Option } from './option-groups.js';

/** An option of a command with the completions of its value. */
interface Completed extends Option {
  name: string;
  /** The completions; an empty list means files. */
  values: readonly string[];
}

/** A command with the completions of its arguments. */
interface Completing {
  name: string;
  about: string;
  options: readonly Completed[];
  /** The completions; an empty list means files. */
  values: readonly string[];
}

export async function completion(args: string[]): Promise<void> {
  const shell = oneOf('completion', oneWord(parsed('completion', args, 'a shell: bash, zsh or fish')), SHELLS);
  const planner = await createPlanner();
  const papers = await planner.paperMethods();
  planner.close();
  const names = {
    machines: planner.machines.map((m) => m.name),
    dialects: planner.dialects.map((d) => d.name),
    methods: [...planner.methods, ...papers].map((m) => m.name),
  };
  const listed = (choices: Choices = []) => (typeof choices === 'string' ? names[choices] : choices);
  const commands = Object.entries(COMMANDS).map(([name, command]: [string, Command]) => ({
    name,
    about: command.about,
    options: Object.entries(optionsOf(name)).map(([option, about]) => ({ name: option, values: listed(about.choices), ...about })),
    values: listed(command.choices),
  }));
  await print(SCRIPTS[shell](commands));
}

const SCRIPTS: Record<(typeof SHELLS)[number], (commands: readonly Completing[]) => string> = { bash, zsh, fish };

const flags = ({ options }: Completing) => options.map((o) => `--${o.name}`).join(' ');

// If the function offers nothing, `-o default` makes bash complete files.
function bash(commands: readonly Completing[]): string {
  const offer = (words: string) => `COMPREPLY=($(compgen -W '${words}' -- "$word"))`;
  const values = commands.flatMap((c) => c.options.filter((o) => o.values.length > 0).map((o) => `    '${c.name} --${o.name}') ${offer(o.values.join(' '))}; return ;;`));
  const files = commands.flatMap((c) => c.options.filter((o) => o.value !== undefined && o.values.length === 0).map((o) => `'${c.name} --${o.name}'`));
  return `# Completes kerfway in bash.
_kerfway() {
  local word="\${COMP_WORDS[COMP_CWORD]}" before="\${COMP_WORDS[COMP_CWORD-1]}" command="\${COMP_WORDS[1]}"
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then ${offer([...commands.map((c) => c.name), 'help'].join(' '))}; return; fi
  case "$command $before" in
    'help help') ${offer(commands.map((c) => c.name).join(' '))}; return ;;
${values.join('\n')}
    ${files.join('|')}) return ;;
  esac
  case "$command" in
${commands.map((c) => `    ${c.name}) case "$word" in -*) ${offer(flags(c))} ;; *) ${c.values.length > 0 ? offer(c.values.join(' ')) : ''} ;; esac ;;`).join('\n')}
  esac
}
complete -o default -F _kerfway kerfway
`;
}

function zsh(commands: readonly Completing[]): string {
  const quoted = (text: string) => text.replaceAll("'", "'\\''").replace(/[[\]:]/g, '\\$&');
  const option = (o: Completed) => {
    const value = o.value === undefined ? '' : `:${quoted(o.value.toLowerCase())}:${o.values.length > 0 ? `(${o.values.join(' ')})` : '_files'}`;
    return `'${o.repeat ? '*' : ''}--${o.name}[${quoted(o.about)}]${value}'`;
  };
  const words = (c: Completing) => (c.values.length > 0 ? `'1:word:(${c.values.join(' ')})'` : "'*:file:_files'");
  return `#compdef kerfway
# Completes kerfway in zsh.
_kerfway() {
  local -a commands
  commands=(${commands.map((c) => `'${c.name}:${quoted(c.about)}'`).join(' ')} 'help:show the options of a command')
  if (( CURRENT == 2 )); then _describe command commands; return; fi
  local command=$words[2]
  shift words; (( CURRENT-- ))
  case $command in
    help) _describe command commands ;;
${commands.map((c) => `    ${c.name}) _arguments ${[...c.options.map(option), words(c)].join(' ')} ;;`).join('\n')}
  esac
}
if [ "$funcstack[1]" = _kerfway ]; then _kerfway "$@"; else compdef _kerfway kerfway; fi
`;
}

function fish(commands: readonly Completing[]): string {
  const quoted = (text: string) => `'${text.replaceAll('\\', '\\\\').replaceAll("'", "\\'")}'`;
  const lines = commands.flatMap((c) => {
    const within = `-n '__fish_seen_subcommand_from ${c.name}'`;
    return [
      `complete -c kerfway -n __fish_use_subcommand -f -a ${c.name} -d ${quoted(c.about)}`,
      ...(c.values.length > 0 ? [`complete -c kerfway ${within} -f -a ${quoted(c.values.join(' '))}`] : []),
      ...c.options.map((o) => {
        const value = o.value === undefined ? '' : o.values.length > 0 ? ` -r -a ${quoted(o.values.join(' '))}` : ' -r';
        return `complete -c kerfway ${within} -l ${o.name}${value} -d ${quoted(o.about)}`;
      }),
    ];
  });
  return `# Completes kerfway in fish.\n${lines.join('\n')}\n`;
}
