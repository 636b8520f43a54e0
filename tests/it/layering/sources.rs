//! Finds which file of a crate uses which other file.
//!
//! This is no compiler. It reads the modules, what each defines and imports, and the paths in the code, and follows
//! re-exports to the file that defines a name. Calls of methods and names that a macro makes stay unseen.

use super::tokens::{is_name, tokens};
use std::collections::{BTreeMap, BTreeSet};

/// A path of names, from the root of the crate or relative.
type Names = Vec<String>;

/// Source files by path below `src`, with `/`.
pub(super) type Files = BTreeMap<String, String>;

/// That one file uses a name that another one defines.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Arrow {
    /// The file that uses it.
    pub(super) from: String,
    /// The file that defines it.
    pub(super) to: String,
    /// The name, from the root of the crate.
    pub(super) name: String,
}

/// What a name means in a module.
enum Meaning {
    /// An item that the module defines.
    Item,
    /// A module inside it.
    Module,
    /// An import, from the root of the crate.
    Import(Names),
}

struct Module {
    file: String,
    names: BTreeMap<String, Meaning>,
    /// Modules of which everything is imported.
    globs: Vec<Names>,
    /// Paths used, and whether that is a re-export only.
    uses: BTreeSet<(Names, bool)>,
}

/// Every arrow between two files. A facade that re-exports a name does not use it.
pub(super) fn arrows(files: &Files) -> Vec<Arrow> {
    let mut modules = BTreeMap::new();
    for (file, text) in files {
        read(file, text, &mut modules);
    }
    let mut found = BTreeSet::new();
    for module in modules.values() {
        for (path, _) in module.uses.iter().filter(|u| !u.1) {
            if let Some((to, name)) = resolve(&modules, path, 0)
                && to != module.file
            {
                found.insert(Arrow { from: module.file.clone(), to, name: name.join("::") });
            }
        }
    }
    found.into_iter().collect()
}

/// The file that defines what a path names, and the path from the root without re-exports.
fn resolve(modules: &BTreeMap<Names, Module>, path: &[String], depth: usize) -> Option<(String, Names)> {
    let mut at: Names = Vec::new();
    for (k, name) in path.iter().enumerate() {
        let module = modules.get(&at)?;
        let rest = &path[k + 1..];
        match module.names.get(name) {
            Some(Meaning::Module) => at.push(name.clone()),
            Some(Meaning::Item) => return Some((module.file.clone(), [at, vec![name.clone()]].concat())),
            Some(Meaning::Import(real)) if depth < 20 => {
                return resolve(modules, &[real.as_slice(), rest].concat(), depth + 1);
            }
            _ => {
                let from = |glob: &Names| {
                    let path = [glob.as_slice(), &path[k..]].concat();
                    if depth < 20 && *glob != at { resolve(modules, &path, depth + 1) } else { None }
                };
                return module.globs.iter().find_map(from);
            }
        }
    }
    modules.get(&at).map(|m| (m.file.clone(), at.clone()))
}

/// Reads a file into its module and those inside it.
fn read(file: &str, text: &str, modules: &mut BTreeMap<Names, Module>) {
    let mut at: Names = file.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    at.pop_if(|last| ["mod", "lib"].contains(&last.as_str()));
    let new =
        || Module { file: file.to_owned(), names: BTreeMap::new(), globs: Vec::new(), uses: BTreeSet::new() };
    modules.insert(at.clone(), new());
    let tokens = tokens(text);
    // Braces that are open, and whether each is that of a module.
    let mut open: Vec<bool> = Vec::new();
    let mut k = 0;
    // First the items of modules, because code may name an item that is defined later.
    while let Some(token) = tokens.get(k) {
        let next = tokens.get(k + 1).map_or("", String::as_str);
        let top = open.iter().all(|m| *m);
        match token.as_str() {
            "{" => open.push(false),
            "}" if open.pop() == Some(true) => {
                at.pop();
            }
            "mod" if is_name(next) && tokens.get(k + 2).is_some_and(|t| t == "{" || t == ";") => {
                define(modules, &at, next, Meaning::Module);
                if tokens[k + 2] == "{" {
                    at.push(next.to_owned());
                    modules.insert(at.clone(), new());
                    open.push(true);
                }
                k += 2;
            }
            "use" => {
                let end = k + tokens[k..].iter().position(|t| t == ";").unwrap_or(0);
                let public = k > 0 && (tokens[k - 1] == "pub" || tokens[k - 1] == ")");
                import(&tokens[k + 1..end], &at, &[], public, modules);
                k = end;
            }
            "struct" | "enum" | "fn" | "const" | "static" | "type" | "trait" | "union"
                if top && is_name(next) && next != "fn" && next != "unsafe" =>
            {
                define(modules, &at, next, Meaning::Item);
            }
            "macro_rules" if top => {
                if let Some(name) = tokens.get(k + 2) {
                    define(modules, &at, name, Meaning::Item);
                }
            }
            _ if is_name(token)
                && next == "::"
                && (k == 0 || !["::", "in"].contains(&tokens[k - 1].as_str())) =>
            {
                let end =
                    (k..).step_by(2).find(|&e| tokens.get(e + 1).is_none_or(|t| t != "::")).unwrap_or(k);
                let path: Names = tokens[k..=end].iter().step_by(2).filter(|t| is_name(t)).cloned().collect();
                if let Some(module) = modules.get_mut(&at) {
                    module.uses.insert((path, false));
                }
            }
            _ => {}
        }
        k += 1;
    }
    let paths: Vec<Names> = modules.keys().filter(|m| modules[*m].file == file).cloned().collect();
    for at in paths {
        let Some(module) = modules.get_mut(&at) else { continue };
        let uses = std::mem::take(&mut module.uses);
        let known = |path: &Names| match path[0].as_str() {
            "crate" | "self" | "super" => true,
            first => module.names.contains_key(first),
        };
        let rooted = uses.into_iter().filter(|u| known(&u.0)).map(|(p, public)| (from_root(&at, &p), public));
        module.uses = rooted.collect();
        for meaning in module.names.values_mut() {
            if let Meaning::Import(path) = meaning {
                *path = from_root(&at, path);
            }
        }
        for glob in &mut module.globs {
            *glob = from_root(&at, glob);
        }
    }
}

fn define(modules: &mut BTreeMap<Names, Module>, at: &Names, name: &str, meaning: Meaning) {
    if let Some(module) = modules.get_mut(at)
        // A function may have the name of a module; paths go on in the module.
        && !matches!(module.names.get(name), Some(Meaning::Module))
    {
        module.names.insert(name.to_owned(), meaning);
    }
}

/// Reads a tree of imports: `a::{b, c as d, e::*}`.
fn import(
    tree: &[String],
    at: &Names,
    before: &[String],
    public: bool,
    modules: &mut BTreeMap<Names, Module>,
) {
    let Some(module) = modules.get_mut(at) else { return };
    let head: Names = tree
        .iter()
        .take_while(|t| *t != "{" && *t != "as" && *t != "*")
        .filter(|t| *t != "::")
        .cloned()
        .collect();
    let mut path = [before, &head].concat();
    match tree.iter().find(|t| ["{", "as", "*"].contains(&t.as_str())).map(String::as_str) {
        Some("{") => {
            let start = tree.iter().position(|t| t == "{").unwrap_or(0);
            let inner = &tree[start + 1..tree.len() - 1];
            let (mut depth, mut from) = (0, 0);
            for k in 0..=inner.len() {
                match inner.get(k).map(String::as_str) {
                    Some("{") => depth += 1,
                    Some("}") => depth -= 1,
                    Some(",") | None if depth == 0 => {
                        if from < k {
                            import(&inner[from..k], at, &path, public, modules);
                        }
                        from = k + 1;
                    }
                    _ => {}
                }
            }
        }
        Some("*") => {
            module.globs.push(path.clone());
            module.uses.insert((path, public));
        }
        other => {
            if path.len() > 1 && path.last().is_some_and(|l| l == "self") {
                path.pop();
            }
            let last = if other == Some("as") { tree.last() } else { path.last() };
            if let Some(name) = last.cloned() {
                // A module of its own, imported by its name, stays one.
                if !matches!(module.names.get(&name), Some(Meaning::Module)) {
                    module.names.insert(name, Meaning::Import(path.clone()));
                }
            }
            module.uses.insert((path, public));
        }
    }
}

/// A path from the root of the crate; of another crate, it leads nowhere.
fn from_root(at: &[String], path: &[String]) -> Names {
    let mut base = at.to_vec();
    let mut rest = path;
    while let Some((first, after)) = rest.split_first() {
        match first.as_str() {
            "crate" => base.clear(),
            "self" => {}
            "super" => {
                base.pop();
            }
            _ => break,
        }
        rest = after;
    }
    base.extend(rest.iter().cloned());
    base
}
