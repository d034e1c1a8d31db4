//! Types with the JSON Schema of another type.

/// Implements `JsonSchema` for a type with the schema of another.
macro_rules! schema_like {
    ([$($generic:tt)*] $Type:ty, $Other:ty) => {
        impl<$($generic)*> schemars::JsonSchema for $Type {
            fn inline_schema() -> bool {
                <$Other>::inline_schema()
            }
            fn schema_name() -> std::borrow::Cow<'static, str> {
                <$Other>::schema_name()
            }
            fn schema_id() -> std::borrow::Cow<'static, str> {
                <$Other>::schema_id()
            }
            fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                <$Other>::json_schema(generator)
            }
        }
    };
}
pub(in crate::toml_scene) use schema_like;
