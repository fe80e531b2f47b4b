using System;
using System.ComponentModel;

namespace Box2D.Dynamics;

/// <summary>A name that the manual uses once for <see cref="b2DestructionListener"/>.</summary>
/// <example>
/// <code>
/// public class MyListener : b2WorldListener
/// {
///     public override void SayGoodbyeJoint(b2Joint joint) => Console.WriteLine("a joint goes");
/// }
/// </code>
/// </example>
[Obsolete("Derive from b2DestructionListener.")]
[EditorBrowsable(EditorBrowsableState.Never)]
public class b2WorldListener : b2DestructionListener
{
}
