using System;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// The categories a geom can belong to and collide with; a set of flags, so combine them with <c>|</c>, remove one with
/// <c>&amp; ~</c> (manual: "Collision group and categories").
/// </summary>
/// <remarks>
/// There are 31 categories, <see cref="Cat1"/> to <see cref="Cat31"/>, each one bit of a positive <see cref="int"/>. What a
/// category stands for is up to the game. A geom's collision categories and the categories it collides with are both
/// <see cref="All"/> unless set.
/// </remarks>
/// <example>
/// <code>
/// geom.CollisionCategories = CollisionCategory.Cat2;
/// geom.CollidesWith = CollisionCategory.All &amp; ~CollisionCategory.Cat2;
/// </code>
/// </example>
[Flags]
public enum CollisionCategory
{
    /// <summary>No category: as the categories to collide with, "nothing". Value 0.</summary>
    None = 0,

    /// <summary>Category 1 (bit 0).</summary>
    Cat1 = 1 << 0,

    /// <summary>Category 2 (bit 1).</summary>
    Cat2 = 1 << 1,

    /// <summary>Category 3 (bit 2).</summary>
    Cat3 = 1 << 2,

    /// <summary>Category 4 (bit 3).</summary>
    Cat4 = 1 << 3,

    /// <summary>Category 5 (bit 4).</summary>
    Cat5 = 1 << 4,

    /// <summary>Category 6 (bit 5).</summary>
    Cat6 = 1 << 5,

    /// <summary>Category 7 (bit 6).</summary>
    Cat7 = 1 << 6,

    /// <summary>Category 8 (bit 7).</summary>
    Cat8 = 1 << 7,

    /// <summary>Category 9 (bit 8).</summary>
    Cat9 = 1 << 8,

    /// <summary>Category 10 (bit 9).</summary>
    Cat10 = 1 << 9,

    /// <summary>Category 11 (bit 10).</summary>
    Cat11 = 1 << 10,

    /// <summary>Category 12 (bit 11).</summary>
    Cat12 = 1 << 11,

    /// <summary>Category 13 (bit 12).</summary>
    Cat13 = 1 << 12,

    /// <summary>Category 14 (bit 13).</summary>
    Cat14 = 1 << 13,

    /// <summary>Category 15 (bit 14).</summary>
    Cat15 = 1 << 14,

    /// <summary>Category 16 (bit 15).</summary>
    Cat16 = 1 << 15,

    /// <summary>Category 17 (bit 16).</summary>
    Cat17 = 1 << 16,

    /// <summary>Category 18 (bit 17).</summary>
    Cat18 = 1 << 17,

    /// <summary>Category 19 (bit 18).</summary>
    Cat19 = 1 << 18,

    /// <summary>Category 20 (bit 19).</summary>
    Cat20 = 1 << 19,

    /// <summary>Category 21 (bit 20).</summary>
    Cat21 = 1 << 20,

    /// <summary>Category 22 (bit 21).</summary>
    Cat22 = 1 << 21,

    /// <summary>Category 23 (bit 22).</summary>
    Cat23 = 1 << 22,

    /// <summary>Category 24 (bit 23).</summary>
    Cat24 = 1 << 23,

    /// <summary>Category 25 (bit 24).</summary>
    Cat25 = 1 << 24,

    /// <summary>Category 26 (bit 25).</summary>
    Cat26 = 1 << 25,

    /// <summary>Category 27 (bit 26).</summary>
    Cat27 = 1 << 26,

    /// <summary>Category 28 (bit 27).</summary>
    Cat28 = 1 << 27,

    /// <summary>Category 29 (bit 28).</summary>
    Cat29 = 1 << 28,

    /// <summary>Category 30 (bit 29).</summary>
    Cat30 = 1 << 29,

    /// <summary>Category 31 (bit 30).</summary>
    Cat31 = 1 << 30,

    /// <summary>All 31 categories; the default of a geom. Value <see cref="int.MaxValue"/>.</summary>
    All = int.MaxValue,
}
