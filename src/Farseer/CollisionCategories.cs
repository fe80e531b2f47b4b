namespace FarseerGames.FarseerPhysics;

/// <summary>
/// The values of <see cref="CollisionCategory"/> under the name that the manual's example code uses (manual: "Collision group
/// and categories").
/// </summary>
/// <remarks>
/// The example declares the type as <c>CollisionCategories</c>, but the type is <see cref="CollisionCategory"/>. With this class
/// an expression such as <c>CollisionCategories.All &amp; ~CollisionCategories.Cat5</c> compiles and has the right type; only a
/// declaration of a variable of this type does not. A second enum was rejected: its values could not be assigned to the
/// properties of a geom.
/// </remarks>
/// <example>
/// <code>
/// geom.CollisionCategories = CollisionCategories.Cat1;
/// geom.CollidesWith = CollisionCategories.All &amp; ~CollisionCategories.Cat2;
/// </code>
/// </example>
public static class CollisionCategories
{
    /// <summary>No category.</summary>
    public const CollisionCategory None = CollisionCategory.None;

    /// <summary>Category 1.</summary>
    public const CollisionCategory Cat1 = CollisionCategory.Cat1;

    /// <summary>Category 2.</summary>
    public const CollisionCategory Cat2 = CollisionCategory.Cat2;

    /// <summary>Category 3.</summary>
    public const CollisionCategory Cat3 = CollisionCategory.Cat3;

    /// <summary>Category 4.</summary>
    public const CollisionCategory Cat4 = CollisionCategory.Cat4;

    /// <summary>Category 5.</summary>
    public const CollisionCategory Cat5 = CollisionCategory.Cat5;

    /// <summary>Category 6.</summary>
    public const CollisionCategory Cat6 = CollisionCategory.Cat6;

    /// <summary>Category 7.</summary>
    public const CollisionCategory Cat7 = CollisionCategory.Cat7;

    /// <summary>Category 8.</summary>
    public const CollisionCategory Cat8 = CollisionCategory.Cat8;

    /// <summary>Category 9.</summary>
    public const CollisionCategory Cat9 = CollisionCategory.Cat9;

    /// <summary>Category 10.</summary>
    public const CollisionCategory Cat10 = CollisionCategory.Cat10;

    /// <summary>Category 11.</summary>
    public const CollisionCategory Cat11 = CollisionCategory.Cat11;

    /// <summary>Category 12.</summary>
    public const CollisionCategory Cat12 = CollisionCategory.Cat12;

    /// <summary>Category 13.</summary>
    public const CollisionCategory Cat13 = CollisionCategory.Cat13;

    /// <summary>Category 14.</summary>
    public const CollisionCategory Cat14 = CollisionCategory.Cat14;

    /// <summary>Category 15.</summary>
    public const CollisionCategory Cat15 = CollisionCategory.Cat15;

    /// <summary>Category 16.</summary>
    public const CollisionCategory Cat16 = CollisionCategory.Cat16;

    /// <summary>Category 17.</summary>
    public const CollisionCategory Cat17 = CollisionCategory.Cat17;

    /// <summary>Category 18.</summary>
    public const CollisionCategory Cat18 = CollisionCategory.Cat18;

    /// <summary>Category 19.</summary>
    public const CollisionCategory Cat19 = CollisionCategory.Cat19;

    /// <summary>Category 20.</summary>
    public const CollisionCategory Cat20 = CollisionCategory.Cat20;

    /// <summary>Category 21.</summary>
    public const CollisionCategory Cat21 = CollisionCategory.Cat21;

    /// <summary>Category 22.</summary>
    public const CollisionCategory Cat22 = CollisionCategory.Cat22;

    /// <summary>Category 23.</summary>
    public const CollisionCategory Cat23 = CollisionCategory.Cat23;

    /// <summary>Category 24.</summary>
    public const CollisionCategory Cat24 = CollisionCategory.Cat24;

    /// <summary>Category 25.</summary>
    public const CollisionCategory Cat25 = CollisionCategory.Cat25;

    /// <summary>Category 26.</summary>
    public const CollisionCategory Cat26 = CollisionCategory.Cat26;

    /// <summary>Category 27.</summary>
    public const CollisionCategory Cat27 = CollisionCategory.Cat27;

    /// <summary>Category 28.</summary>
    public const CollisionCategory Cat28 = CollisionCategory.Cat28;

    /// <summary>Category 29.</summary>
    public const CollisionCategory Cat29 = CollisionCategory.Cat29;

    /// <summary>Category 30.</summary>
    public const CollisionCategory Cat30 = CollisionCategory.Cat30;

    /// <summary>Category 31.</summary>
    public const CollisionCategory Cat31 = CollisionCategory.Cat31;

    /// <summary>All 31 categories.</summary>
    public const CollisionCategory All = CollisionCategory.All;
}
