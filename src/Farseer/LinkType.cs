namespace FarseerGames.FarseerPhysics;

/// <summary>What holds two neighbouring links of a <see cref="Dynamics.Path"/> together.</summary>
/// <example>
/// <code>
/// Path rope = ComplexFactory.Instance.CreateChain(
///     simulator, new Vector2(0, 0), new Vector2(10, 0), 20, 0.2f, 1, 1, LinkType.RevoluteJoint);
/// </code>
/// </example>
public enum LinkType
{
    /// <summary>
    /// A <see cref="Dynamics.Joints.RevoluteJoint"/> midway between the two centres: the links follow each other like those of a chain.
    /// </summary>
    RevoluteJoint = 0,

    /// <summary>A <see cref="Dynamics.Joints.PinJoint"/>, a rod, between the ends that face each other.</summary>
    PinJoint = 1,

    /// <summary>A <see cref="Dynamics.Joints.SliderJoint"/> between the ends that face each other, with limits of your own.</summary>
    SliderJoint = 2,

    /// <summary>A <see cref="Dynamics.Springs.LinearSpring"/> between the ends that face each other.</summary>
    LinearSpring = 3,
}
