//! Expansion of simple macro calls: of macros with one rule whose variables are names.

use std::collections::HashMap;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// A macro with one rule.
pub struct Rule {
    /// Variables and literal words.
    pattern: Vec<Word>,
    body: TokenStream,
}

#[derive(PartialEq, Eq, Debug)]
enum Word {
    Variable(String),
    Literal(String),
}

impl Rule {
    /// The rule of a macro definition; `None` if there is more than one.
    pub fn of(definition: TokenStream) -> Option<Rule> {
        let mut groups = definition.into_iter().filter_map(|token| match token {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        });
        let (pattern, body) = (groups.next()?, groups.next()?);
        groups.next().is_none().then(|| Rule { pattern: pattern_of(pattern), body })
    }

    /// The expansion of a call without documentation; `None` if the call does not match the pattern word by
    /// word.
    pub fn expanded(&self, call: TokenStream) -> Option<TokenStream> {
        let words = words(call)?;
        if words.len() != self.pattern.len() {
            return None;
        }
        let mut values = HashMap::new();
        for (word, given) in self.pattern.iter().zip(words) {
            match word {
                Word::Variable(name) => _ = values.insert(name.clone(), given),
                Word::Literal(word) if given.to_string() == *word => {}
                Word::Literal(_) => return None,
            }
        }
        Some(substitute(self.body.clone(), &values))
    }
}

/// The words of a pattern, without repetitions.
fn pattern_of(tokens: TokenStream) -> Vec<Word> {
    let mut pattern = Vec::new();
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(it) if it.as_char() == '$' => match tokens.next() {
                Some(TokenTree::Ident(name)) => {
                    pattern.push(Word::Variable(name.to_string()));
                    // The colon and the kind.
                    tokens.nth(1);
                }
                _ => repetition(&mut tokens),
            },
            TokenTree::Ident(it) => pattern.push(Word::Literal(it.to_string())),
            _ => {}
        }
    }
    pattern
}

/// Skips the separator and the operator of `$(..),*`.
fn repetition(tokens: &mut impl Iterator<Item = TokenTree>) {
    let is_operator =
        |token: &TokenTree| matches!(token, TokenTree::Punct(it) if "*+?".contains(it.as_char()));
    tokens.find(is_operator);
}

/// The words of a call without its attributes; `None` if there are other tokens.
fn words(call: TokenStream) -> Option<Vec<TokenTree>> {
    let mut words = Vec::new();
    let mut tokens = call.into_iter();
    while let Some(token) = tokens.next() {
        match &token {
            TokenTree::Ident(_) => words.push(token),
            TokenTree::Punct(it) if it.as_char() == '#' => _ = tokens.next(),
            TokenTree::Punct(it) if it.as_char() == ',' => {}
            _ => return None,
        }
    }
    Some(words)
}

/// Substitutes the variables of a body, and removes repetitions.
fn substitute(body: TokenStream, values: &HashMap<String, TokenTree>) -> TokenStream {
    let mut output = Vec::new();
    let mut tokens = body.into_iter();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(it) if it.as_char() == '$' => match tokens.next() {
                Some(TokenTree::Ident(name)) => {
                    let value = values.get(&name.to_string()).cloned();
                    output.push(value.unwrap_or(TokenTree::Ident(name)));
                }
                _ => repetition(&mut tokens),
            },
            TokenTree::Group(group) => {
                let inside = substitute(group.stream(), values);
                output.push(TokenTree::Group(Group::new(group.delimiter(), inside)));
            }
            other => output.push(other),
        }
    }
    output.into_iter().collect()
}

/// Whether the tokens contain a public function.
pub fn has_public_functions(tokens: TokenStream) -> bool {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let words: Vec<String> = tokens.iter().map(TokenTree::to_string).collect();
    let is_one =
        |words: &[String]| words[0] == "pub" && (words[1] == "fn" || words[1] == "const" && words[2] == "fn");
    let is_in = |token: &TokenTree| matches!(token, TokenTree::Group(it) if it.delimiter() != Delimiter::None && has_public_functions(it.stream()));
    words.windows(3).any(is_one) || tokens.iter().any(is_in)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn expanded(definition: &str, call: &str) -> Option<String> {
        let parse = |text: &str| text.parse::<TokenStream>().unwrap();
        Rule::of(parse(definition))?.expanded(parse(call)).map(|tokens| tokens.to_string().replace(' ', ""))
    }

    #[test]
    fn names_are_substituted_and_attributes_left_out() {
        let definition = "($(#[$doc:meta])* $Set:ident of $Kind:ident) => { $(#[$doc])* struct $Set; impl $Set { fn f(k: $Kind) {} } }";
        let is = "structA;implA{fnf(k:B){}}";
        assert_eq!(expanded(definition, "A of B").as_deref(), Some(is));
        assert_eq!(expanded(definition, "/// What it is.\n A of B").as_deref(), Some(is));
        assert_eq!(expanded(definition, "A in B"), None);
        assert_eq!(expanded(definition, "A of"), None);
        assert_eq!(expanded(definition, "A of 3"), None);
    }

    #[test]
    fn more_than_one_rule_is_not_expanded() {
        assert_eq!(expanded("($A:ident) => { $A } ; () => {}", "B"), None);
    }

    #[test]
    fn public_functions_are_found() {
        let has = |text: &str| has_public_functions(text.parse().unwrap());
        assert!(has("impl A { pub fn f() {} }") && has("{ pub const fn f() {} }"));
        assert!(!has("impl A { fn f() {} pub const C: u8 = 0; }"));
    }
}
