//! The types of plain objects, told in TypeScript.

/// The declarations of a set of types, each standing once, before those that it names.
#[derive(Clone, Debug, Default)]
pub struct Types {
    declared: Vec<(&'static str, String)>,
}

/// One field of an interface: its name, what is said of it, and its type.
pub type Declared = (&'static str, &'static [&'static str], String);

impl Types {
    /// All declarations.
    pub fn declarations(&self) -> String {
        self.declared.iter().map(|(_, text)| text.as_str()).collect()
    }

    /// The name of an interface, which is declared if it is not yet.
    pub fn interface(
        &mut self,
        name: &'static str,
        about: &[&str],
        fields: impl FnOnce(&mut Self) -> Vec<Declared>,
    ) -> String {
        self.declare(name, |types| {
            let fields: String = fields(types)
                .into_iter()
                .map(|(name, about, kind)| format!("{}  {name}: {kind};\n", comment(about, "  ")))
                .collect();
            format!("{}export interface {name} {{\n{fields}}}\n", comment(about, ""))
        })
    }

    /// The name for another type.
    pub fn alias(&mut self, name: &'static str, about: &[&str], kind: &str) -> String {
        self.declare(name, |_| format!("{}export type {name} = {kind};\n", comment(about, "")))
    }

    fn declare(&mut self, name: &'static str, text: impl FnOnce(&mut Self) -> String) -> String {
        if self.declared.iter().all(|(known, _)| *known != name) {
            let place = self.declared.len();
            self.declared.push((name, String::new()));
            self.declared[place].1 = text(self);
        }
        name.into()
    }
}

/// A comment on what follows, in lines like those that were written in Rust.
fn comment(lines: &[&str], indent: &str) -> String {
    match lines {
        [line] => format!("{indent}/** {} */\n", line.trim()),
        lines => {
            let text = lines.iter().map(|line| format!("{indent} * {}", line.trim()));
            let text: Vec<String> = text.map(|line| line.trim_end().into()).collect();
            format!("{indent}/**\n{}\n{indent} */\n", text.join("\n"))
        }
    }
}
